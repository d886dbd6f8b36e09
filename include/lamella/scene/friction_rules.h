// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_friction_rules_h
#define lamella_scene_friction_rules_h

#include <lamella/base/entry.h>
#include <lamella/scene/scene.h>

namespace lamella
{
  /// Throws InputError for entries of @p scene that do not fit its friction:
  /// - with friction, a tolerance of goals;
  /// - without friction, `Substeps` other than 1 (a top-level entry in @p in);
  /// - a goal or Trade quantity `dissipated` of a contact without friction.
  void
  check_friction(const Scene &scene, const Entries &in);
} // namespace lamella

#endif
