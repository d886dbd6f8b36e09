// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_solution_check_h
#define lamella_solve_solution_check_h

#include <lamella/solve/checks.h>
#include <lamella/solve/tangent_operator.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Throws NumericsError if @p state is not reliable. Tests in this order:
  /// stabilizing springs with more than a tenth of the energy; last corrections
  /// of iterative refinement above 1e-6 of the displacements; force, moment or
  /// energy balance or residual above 1e-3; a tensile contact force, or an
  /// error of the contact law above 1e-6 of the displacements; values that are
  /// not finite; a rotation above @p rotation_limit [rad].
  void
  check_solution(const State  &state,
                 const Checks &checks,
                 const double  rotation_limit);

  /// Throws NumericsError if support points miss their prescribed positions at
  /// load factor @p at, in the state of @p here (finite rotations), since
  /// several supports of the same points agree to first order only. The
  /// tolerance is ten times the effect of rotated warping.
  void
  check_followed(const TangentOperator &here, const LoadFactor &at);

  /// Returns warnings about a reliable @p state, one sentence each:
  /// penetrations above 1e-3, or differences of weighted and pointwise gaps
  /// above 1e-2, of the displacements; initial overlaps; rotations above 0.1
  /// rad; springs with more than 1e-3 of the energy; errors of balances, or a
  /// first correction of iterative refinement, above 1e-7.
  std::vector<std::string>
  warnings_of(const State                         &state,
              const Checks                        &checks,
              const std::vector<ContactInterface> &contacts);
} // namespace lamella

#endif
