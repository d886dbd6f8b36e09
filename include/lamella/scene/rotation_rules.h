// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_rotation_rules_h
#define lamella_scene_rotation_rules_h

#include <lamella/base/entry.h>
#include <lamella/scene/scene.h>

namespace lamella
{
  /**
   * Makes of @p scene, whose top level is @p in, one of bodies that turn by any
   * angle, where it says `Rotations = large`: these (BodyDescription::turns),
   * contacts whose rows may slide, and no error bars unless they are asked for.
   *
   * Throws InputError for what large rotations are not made for, entry by
   * entry: theories that cannot deform as a turned one does, axes that lock,
   * solids, node-dependent theories, Stabilisation and Hold, Temperature,
   * friction, pairs of nodes, the full strategy, Find, error bars and
   * tolerances, stresses by equilibrium, several processes.
   */
  void
  take_rotations(Scene &scene, const Entries &in);
} // namespace lamella

#endif
