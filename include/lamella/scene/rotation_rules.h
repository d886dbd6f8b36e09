// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_rotation_rules_h
#define lamella_scene_rotation_rules_h

#include <lamella/scene/scene.h>

namespace lamella
{
  /**
   * @p scene as one of bodies that turn by any angle: these
   * (BodyDescription::turns), contacts whose rows may slide, and no error bars
   * unless they are asked for.
   *
   * Throws InputError for what large rotations are not made for, entry by
   * entry: theories that cannot deform as a turned one does, axes that lock,
   * solid-1, node-dependent theories, Stabilisation and Hold, pairs of
   * nodes, the full strategy, error bars and tolerances, stresses by
   * equilibrium, several processes.
   */
  Scene
  turning(Scene scene);

  /// Whether bodies of @p theory turn by any angle.
  bool
  can_turn(const Theory &theory);

  /// Returns whether `line to roller` is possible for @p contact of @p body: a
  /// beam's line that is nearest to a roller across the beam.
  bool
  can_be_line(const ContactPair &contact, const BodyDescription &body);

  /// Whether @p scene has what is of large rotations alone: loads that follow.
  bool
  asks_to_turn(const Scene &scene);

  /// Makes @p scene what its `Rotations` say: turning() where they are large.
  /// Where they are automatic nothing is decided, but linear where turning()
  /// throws and nothing asks for it, which a warning of the scene says. Throws
  /// InputError as it does, and for what is of large rotations alone.
  void
  take_rotations(Scene &scene);
} // namespace lamella

#endif
