// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_rotation_rules_h
#define lamella_scene_rotation_rules_h

#include <lamella/scene/scene.h>

namespace lamella
{
  /// Returns @p scene with finite rotations of its bodies and finite-sliding
  /// contacts. Error bars are disabled unless the scene requests them.
  ///
  /// Throws InputError for entries that large rotations do not allow: theories
  /// without finite-rotation kinematics, axis elements that lock, solid-1,
  /// node-dependent theories, `Stabilization`, `Isostatic support`,
  /// node-to-node contact, the strategy `full`, error bars and tolerances,
  /// stresses by equilibrium. Several processes are not allowed either.
  Scene
  with_finite_rotations(Scene scene);

  /// Returns whether bodies of @p theory can have finite rotations.
  bool
  can_rotate(const Theory &theory);

  /// Returns whether @p contact of @p body with a cylindrical obstacle may be
  /// `line to roller`, contact along the line of the beam surface that is
  /// nearest to a cylinder across the beam.
  bool
  allows_line_contact(const ContactPair &contact, const BodyDescription &body);

  /// Returns whether @p scene has entries that require finite rotations.
  bool
  requests_finite_rotations(const Scene &scene);

  /// Applies the entry `Rotations` to @p scene. If it is `large`, calls
  /// with_finite_rotations(). If it is `auto`, the run chooses later; but if
  /// with_finite_rotations() throws, rotations become `linear` with a warning.
  /// Throws as with_finite_rotations() if entries require finite rotations, and
  /// InputError if these are combined with `linear`.
  void
  apply_rotations(Scene &scene);
} // namespace lamella

#endif
