// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_friction_rules_h
#define lamella_scene_friction_rules_h

#include <lamella/base/entry.h>
#include <lamella/scene/scene.h>

namespace lamella
{
  /// Throws InputError if @p scene, with the top-level entries @p in, combines
  /// contact friction with the strategy `full` (its matrix is unsymmetric then)
  /// or with a tolerance of goals; or if a scene without friction has entries
  /// that need friction (`Substeps`, the dissipation of a contact).
  void
  check_friction(const Scene &scene, const Entries &in);
} // namespace lamella

#endif
