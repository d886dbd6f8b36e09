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

  /// The compliance C^-1 of @p ply in the body frame.
  ElasticTensor
  compliance(const Ply &ply);

  /**
   * The shear stiffness k G A of a stack of plies for shear through its
   * thickness, V = k G A gamma, from equilibrium of the plies,
   *   1 / (k G A) = int S(z)^2 / (G b) dz / (E I)^2,
   *   S(z) = int_bottom^z E (z' - z_0) b dz',
   * with z_0 the neutral axis, E and G of each ply along the beam (Jourawski's
   * formula; 5/6 G A of one ply). [force]
   */
  double
  shear_stiffness(const std::vector<Ply> &plies, const double width);

  /**
   * The same where u_y is a polynomial of degree @p N over the thickness: the
   * warping that minimises the energy among these. Larger than the above, and
   * many times so in sandwiches, whose warping has a kink at each face.
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
   */
  std::optional<double>
  torsional_stiffness(const Section &section);

  /// The same in LE-2 on @p mesh; none for more cells (150) than a note is
  /// worth.
  std::optional<double>
  torsional_stiffness(const SectionMesh &mesh);
} // namespace lamella

#endif
