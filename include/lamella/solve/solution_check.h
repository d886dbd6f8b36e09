// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_solution_check_h
#define lamella_solve_solution_check_h

#include <lamella/solve/checks.h>
#include <lamella/solve/tangent_operator.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Throws NumericsError if @p state is not reliable, i.e. if
  /// - stabilizing springs store more than a tenth of the energy,
  /// - the last correction of a refinement exceeds 1e-6 of the displacements,
  /// - the residual, or a force, moment or energy balance, exceeds 1e-3,
  /// - a contact force is tensile,
  /// - an error of the contact law exceeds 1e-6 of the displacements,
  /// - values are not finite, or a rotation exceeds @p rotation_limit [rad], or
  /// - the rms axial strain of a section exceeds 5 % (finite rotations).
  void
  check_solution(const State  &state,
                 const Checks &checks,
                 const double  rotation_limit);

  /// Throws NumericsError if supports of the same points contradict each other
  /// at finite rotations: if points in the state of @p here are not at their
  /// prescribed positions at load factor @p at. The tolerance is ten times the
  /// displacement error that rotation of warped sections causes.
  void
  check_followed(const TangentOperator &here, const LoadFactor &at);

  /// Returns warnings about a reliable @p state, one sentence each, if
  /// - bodies overlap initially, or penetrate by 1e-3 of the displacements,
  /// - mean and pointwise gaps of a contact differ by 1e-2 of these,
  /// - rotations exceed 0.1 rad, or springs store more than 1e-3 of the energy,
  /// - errors of balances, or the first refinement correction, exceed 1e-7, or
  /// - strains or rotations within elements are large (finite rotations).
  std::vector<std::string>
  warnings_of(const State                         &state,
              const Checks                        &checks,
              const std::vector<ContactInterface> &contacts);
} // namespace lamella

#endif
