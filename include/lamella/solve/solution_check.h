// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_solution_check_h
#define lamella_solve_solution_check_h

#include <lamella/solve/checks.h>
#include <lamella/solve/tangent_operator.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Throws NumericsError if the state is not reliable. Checked in this order:
  /// stabilizing springs with more than a tenth of the energy; last corrections
  /// above 1e-6 of the displacements; balance of forces or moments, residual or
  /// energy balance above 1e-3; a tensile contact force, or an error of the
  /// contact law above 1e-6 of the displacements; values that are not finite; a
  /// rotation above @p rotation_limit [rad].
  void
  check_solution(const State  &state,
                 const Checks &checks,
                 const double  rotation_limit);

  /// Throws NumericsError if points of a support with finite rotations are off
  /// their prescribed positions at load factor @p at in the state of @p here,
  /// because several supports prescribe the same points and agree to first
  /// order only. (Accepted: ten times the effect of rotated warping.)
  void
  check_followed(const TangentOperator &here, const LoadFactor &at);

  /// Returns warnings about a reliable state, one sentence each: penetrations
  /// above 1e-3 of the displacements; differences between weighted gaps and the
  /// gaps at their points above 1e-2 of the displacements; initial overlaps;
  /// rotations beyond 0.1 rad; springs with more than 1e-3 of the energy;
  /// relative errors of the balances above 1e-7; and digits lost by the matrix
  /// (a first correction above 1e-7). @p contacts are those of check_state().
  std::vector<std::string>
  warnings_of(const State                         &state,
              const Checks                        &checks,
              const std::vector<ContactInterface> &contacts);
} // namespace lamella

#endif
