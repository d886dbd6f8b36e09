// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_friction_step_h
#define lamella_solve_friction_step_h

#include <lamella/solve/contact_problem.h>
#include <lamella/solve/state.h>

#include <vector>

namespace lamella
{
  /// Returns the forces of the constraints: normal and two tangential.
  std::vector<dealii::Tensor<1, 3>>
  forces_by_rows(const GapConstraints &rows, const State &state);

  /// Returns the slip of constraint number @p r in the load step, s + a
  /// lambda_t - s_0 (FrictionState) [length].
  dealii::Tensor<1, 2>
  slip_in_step(const GapConstraint &row,
               const unsigned int   r,
               const State         &state,
               const LoadFactor    &factor);

  /// Sets slips, shear forces and initial forces of @p problem from @p state.
  void
  add_friction(const GapConstraints &rows,
               const State          &state,
               const LoadFactor     &factor,
               ContactProblem       &problem);

  /// Stores the forces @p found by a contact strategy in @p state.
  void
  store_forces(const GapConstraints  &rows,
               const ContactSolution &found,
               State                 &state);

  /// Returns the active gaps, sticking and slipping constraints of @p state.
  ActiveConstraints
  active_equations(const GapConstraints &rows, const State &state);

  /// Adds the increments @p dlambda to the forces of @p state; the shear forces
  /// of slipping constraints change with their normal forces.
  void
  add_forces(const GapConstraints    &rows,
             const ActiveConstraints &closed,
             const Vector            &dlambda,
             State                   &state);

  /// Returns the friction error of the active constraint @p r in @p state
  /// [length]: |v| if it sticks, |v + |v| e| if it slips, with the slip v =
  /// slip_in_step() and the unit vector e along the shear force.
  double
  friction_error(const GapConstraint &row,
                 const unsigned int   r,
                 const State         &state,
                 const LoadFactor    &factor);

  /// Updates the friction variables of @p state at the end of a load step from
  /// @p before: slips, slip lengths and dissipated energy.
  void
  end_step(const GapConstraints &rows,
           const State          &before,
           const LoadFactor     &factor,
           State                &state);

  /// Updates the friction variables as end_step() does for moving contacts,
  /// whose slips are zero at the beginning of each load step.
  void
  end_moved_step(const GapConstraints &rows,
                 const State          &before,
                 const LoadFactor     &factor,
                 State                &state);
} // namespace lamella

#endif
