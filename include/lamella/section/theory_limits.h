// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_theory_limits_h
#define lamella_section_theory_limits_h

#include <lamella/section/section.h>

#include <optional>
#include <vector>

namespace lamella
{
  // Stiffnesses of a section or laminate alone, for the accuracy of a theory.

  /// Returns the compliance S = C^-1 of @p ply in body axes [length^2/force]. 1
  /// / S_22 is Young's modulus along the beam, 1 / S_66 the modulus G_yz.
  ElasticTensor
  compliance(const Ply &ply);

  /// Returns the transverse shear stiffness k G A [force] of a laminate, i.e.
  /// the shear force per shear strain, from equilibrium of the plies
  /// (Jourawski's formula; 5/6 G A for one ply),
  ///   1 / (k G A) = int S(z)^2 / (G b) dz / (E I)^2,
  ///   S(z) = int_bottom^z E (z' - z_0) b dz',
  /// with the neutral axis z_0 and the width b = @p width [length]. E = 1 /
  /// S_22 and G = 1 / S_66 of each ply by compliance().
  double
  shear_stiffness(const std::vector<Ply> &plies, const double width);

  /// Returns the transverse shear stiffness [force] of a laminate in a theory
  /// with u_y of degree @p N over the thickness. It exceeds the stiffness from
  /// equilibrium, in sandwiches by a large factor. For the shear force V, the
  /// warping w(z), a sum of Legendre polynomials of degrees 1 to N, minimizes
  ///   1/2 int G w'^2 b dz - V int E (z - z_0) w b dz / (E I).
  /// with the moduli E, G of each ply, the neutral axis z_0 and the width b.
  /// For @p N = 1, the result is int G dA.
  double
  shear_stiffness(const std::vector<Ply> &plies,
                  const double            width,
                  const unsigned int      N);

  /// Returns the torsional stiffness G J [force length^2] of @p section in its
  /// theory: the torque for a unit twist per length with the warping of minimum
  /// energy (Saint-Venant torsion). Returns an empty optional for theories
  /// without torsion, more than 2500 section functions or extremely thin cells.
  ///
  /// With the section matrices S_pq (see Section), the rotation r about y, the
  /// reference length h, and coefficients w of all other section functions
  /// except translations,
  ///   S_00 w = -S_01 r,   G J = h^2 (S_11 rr + w . S_01 r),
  /// so that the section rotates about its shear center.
  std::optional<double>
  torsional_stiffness(const Section &section);

  /// Returns the torsional stiffness G J [force length^2] computed with LE-2 on
  /// @p mesh, a reference for Taylor theories; empty for more than 150 cells.
  std::optional<double>
  torsional_stiffness(const SectionMesh &mesh);
} // namespace lamella

#endif
