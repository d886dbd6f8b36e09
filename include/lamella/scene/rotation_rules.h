// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_rotation_rules_h
#define lamella_scene_rotation_rules_h

#include <lamella/scene/scene.h>

namespace lamella
{
  /// Returns @p scene with finite rotations of bodies and finite sliding in
  /// contacts. Throws InputError for entries that finite rotations exclude:
  /// - theories that cannot represent finite rotations (see can_rotate()) or
  ///   that differ between nodes, and B2 and B3 elements of beams whose
  ///   sections deform;
  /// - node-to-node contact, and the contact strategy `full`;
  /// - tolerances, error bars by finer models, and stresses by equilibrium.
  Scene
  with_finite_rotations(Scene scene);

  /// Returns true if bodies of @p theory can have finite rotations: EBBT, TBT,
  /// SV-N, LE-N, TE-N with N > 1, and solid-2.
  bool
  can_rotate(const Theory &theory);

  /// Returns true if @p contact of @p body with a cylindrical obstacle across
  /// the beam may have the discretization `line to roller`: contact constraints
  /// along the line of the beam's surface that is nearest to the cylinder.
  bool
  allows_line_contact(const ContactPair &contact, const BodyDescription &body);

  /// Returns true if @p scene requires finite rotations (follower loads).
  bool
  requests_finite_rotations(const Scene &scene);

  /// Applies the entry `Rotations` to @p scene:
  /// - `large`: calls with_finite_rotations();
  /// - `linear`: throws InputError if the scene requires finite rotations;
  /// - `auto`: if finite rotations are possible, LinearTrial chooses during the
  ///   run. Otherwise sets `linear` with a warning, or throws InputError if the
  ///   scene requires finite rotations.
  void
  apply_rotations(Scene &scene);
} // namespace lamella

#endif
