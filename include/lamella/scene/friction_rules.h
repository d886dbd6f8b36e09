// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_friction_rules_h
#define lamella_scene_friction_rules_h

#include <lamella/base/entry.h>
#include <lamella/scene/scene.h>

namespace lamella
{
  /// Throws InputError if @p scene has a contact with friction and a tolerance
  /// of goals. Throws also if it has no friction, but the top-level entry
  /// `Substeps` (in @p in), or a dissipated energy as goal or Trade quantity.
  void
  check_friction(const Scene &scene, const Entries &in);
} // namespace lamella

#endif
