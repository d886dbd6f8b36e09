// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_friction_rules_h
#define lamella_scene_friction_rules_h

#include <lamella/base/entry.h>
#include <lamella/scene/scene.h>

namespace lamella
{
  /// Throws InputError for what in @p scene, whose top level is @p in, friction
  /// is not made for: a matrix that is not symmetric (`full`), and passes of a
  /// run to a tolerance, which make no load steps shorter; and for what a scene
  /// without friction has not got: Substeps, and what a contact dissipates.
  void
  check_friction(const Scene &scene, const Entries &in);
} // namespace lamella

#endif
