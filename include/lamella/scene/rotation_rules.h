// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_rotation_rules_h
#define lamella_scene_rotation_rules_h

#include <lamella/scene/scene.h>

namespace lamella
{
  /**
   * Returns @p scene with finite rotations of its bodies, with contacts of
   * finite sliding, and without error bars unless they are set.
   *
   * Throws InputError for entries that large rotations do not allow: theories
   * without finite-rotation kinematics, axes that lock, solid-1, node-dependent
   * theories, Stabilization and Isostatic support, pairs of nodes, the full
   * strategy, error bars and tolerances, stresses by equilibrium, several
   * processes.
   */
  Scene
  with_finite_rotations(Scene scene);

  /// Returns whether bodies of @p theory can have finite rotations.
  bool
  can_rotate(const Theory &theory);

  /// Returns whether @p contact of @p body may be `line to roller`: contact at
  /// the line of a beam that is nearest to a roller across the beam.
  bool
  allows_line_contact(const ContactPair &contact, const BodyDescription &body);

  /// Returns whether @p scene has entries that need large rotations.
  bool
  requests_finite_rotations(const Scene &scene);

  /// Applies `Rotations` to @p scene: with_finite_rotations() if they are
  /// large. Automatic rotations stay undecided, but become linear, with a
  /// warning of the scene, if that function throws and no entry needs large
  /// ones. Throws what it throws, and InputError for linear rotations with
  /// entries that need large ones.
  void
  apply_rotations(Scene &scene);
} // namespace lamella

#endif
