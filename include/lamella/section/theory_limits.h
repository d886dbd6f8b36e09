// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_theory_limits_h
#define lamella_section_theory_limits_h

#include <lamella/section/section.h>

#include <optional>
#include <vector>

namespace lamella
{
  // What a theory cannot follow, from the section alone: notes for the user
  // before anything is solved.

  /// The compliance S = C^-1 of @p ply in the body frame [length^2/force], in
  /// the order of Eq. 4: 1 / S_22 is the ply's modulus along the beam where it
  /// contracts freely, 1 / S_66 its G_yz.
  ElasticTensor
  compliance(const Ply &ply);

  /**
   * The shear stiffness k G A of a stack of plies for shear through its
   * thickness, V = k G A gamma, from equilibrium of the plies,
   *   1 / (k G A) = int S(z)^2 / (G b) dz / (E I)^2,
   *   S(z) = int_bottom^z E (z' - z_0) b dz',
   * with z_0 the neutral axis, E and G of each ply along the beam (Jourawski's
   * formula; 5/6 G A of one ply). [force]
   *
   * S is the first moment of the plies below z, weighted with E, and b =
   * @p width [length]. @p plies lie on each other, bottom to top; E = 1 / S_22
   * and G = 1 / S_66 of compliance(). It is the shear stiffness that
   * Timoshenko's theory would need: over int G dA it is the shear correction
   * factor.
   */
  double
  shear_stiffness(const std::vector<Ply> &plies, const double width);

  /**
   * The same where u_y is a polynomial of degree @p N over the thickness: the
   * warping that minimises the energy among these. Larger than the above, and
   * many times so in sandwiches, whose warping has a kink at each face.
   *
   * With u_y = w(z) beyond the plane section, w = sum_i a_i P_i of Legendre
   * polynomials i = 1 ... N, it minimises
   *   1/2 int G w'^2 b dz - V int E (z - z_0) w b dz / (E I),
   * so it is 1 over a Galerkin approximation of the flexibility from below.
   * @p N from 1, which gives int G dA: TBT with a shear factor of 1. [force]
   */
  double
  shear_stiffness(const std::vector<Ply> &plies,
                  const double            width,
                  const unsigned int      N);

  /**
   * The torsional stiffness G J of @p section in the space of its theory: the
   * torque of a unit twist per length, with that warping which minimises the
   * energy (Saint-Venant's torsion, axial force and bending held at zero
   * strain). None for theories without torsion, and for sections of so many
   * fields (some thousands) that it would take longer than a note is worth, or
   * with cells so thin that rounding leaves nothing of it.
   *
   * With r the rotation field about y and w the amplitudes of all fields but it
   * and the translations,
   *   S_00 w = -S_01 r,   G J = h^2 (S_11 rr + w . S_01 r),
   * h the reference length: the Schur complement of the warping. The slopes are
   * among the w: the section may turn about its shear centre. A dense Cholesky
   * factorisation, so at most 2500 fields. [force length^2]
   */
  std::optional<double>
  torsional_stiffness(const Section &section);

  /// The same in LE-2 on @p mesh; none for more cells (150) than a note is
  /// worth. What the torsion of Taylor theories is judged by. Refers to @p mesh
  /// for the time of the call.
  std::optional<double>
  torsional_stiffness(const SectionMesh &mesh);
} // namespace lamella

#endif
