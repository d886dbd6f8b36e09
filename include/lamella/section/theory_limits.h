// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_theory_limits_h
#define lamella_section_theory_limits_h

#include <lamella/section/section.h>

#include <optional>
#include <vector>

namespace lamella
{
  // Limits of a theory from the section alone, for notes before a solution.

  /// Returns the compliance S = C^-1 of @p ply in the body frame
  /// [length^2/force]: 1 / S_22 is the modulus along the beam, 1 / S_66 is
  /// G_yz.
  ElasticTensor
  compliance(const Ply &ply);

  /// Returns the shear stiffness k G A [force] of a stack of plies for shear
  /// through its thickness, V = k G A gamma, from equilibrium of the plies
  /// (Jourawski's formula; 5/6 G A of one ply),
  ///   1 / (k G A) = int S(z)^2 / (G b) dz / (E I)^2,
  ///   S(z) = int_bottom^z E (z' - z_0) b dz',
  /// with the neutral axis z_0, b = @p width [length] and, of @p plies from
  /// bottom to top, E = 1 / S_22 and G = 1 / S_66 of compliance().
  double
  shear_stiffness(const std::vector<Ply> &plies, const double width);

  /// Returns the shear stiffness [force] of a stack of plies if u_y is a
  /// polynomial of degree @p N over the thickness, the minimum of energy among
  /// these. It exceeds that from equilibrium, many times in sandwiches. The
  /// displacement u_y = w(z) beyond the plane section, w = sum_i a_i P_i of
  /// Legendre polynomials i = 1 ... N, minimizes
  ///   1/2 int G w'^2 b dz - V int E (z - z_0) w b dz / (E I).
  /// @p N = 1 gives int G dA: TBT with a shear factor of 1.
  double
  shear_stiffness(const std::vector<Ply> &plies,
                  const double            width,
                  const unsigned int      N);

  /**
   * Returns the torsional stiffness G J [force length^2] of @p section in the
   * space of its theory: the torque of a unit twist per length with the warping
   * of least energy (Saint-Venant's torsion). None for theories without
   * torsion, for more than 2500 fields, and for cells so thin that rounding
   * dominates.
   *
   * The rotation field r about y and the amplitudes w of all fields but it and
   * the translations give the Schur complement of the warping,
   *   S_00 w = -S_01 r,   G J = h^2 (S_11 rr + w . S_01 r),
   * with the reference length h. w includes the slopes, so that the section
   * rotates about its shear center.
   */
  std::optional<double>
  torsional_stiffness(const Section &section);

  /// Returns the torsional stiffness in LE-2 on @p mesh, the reference for
  /// Taylor theories; none for more than 150 cells.
  std::optional<double>
  torsional_stiffness(const SectionMesh &mesh);
} // namespace lamella

#endif
