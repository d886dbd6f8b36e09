// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_friction_rules_h
#define lamella_scene_friction_rules_h

#include <lamella/base/entry.h>
#include <lamella/scene/scene.h>

namespace lamella
{
  /// Throws InputError for entries of @p scene, with the top level @p in, that
  /// friction does not allow: the strategy `full`, since the matrix is not
  /// symmetric, and runs to a tolerance. Throws it also for entries that need
  /// friction: Substeps, and the dissipation of a contact.
  void
  check_friction(const Scene &scene, const Entries &in);
} // namespace lamella

#endif
