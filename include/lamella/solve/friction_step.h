// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_friction_step_h
#define lamella_solve_friction_step_h

#include <lamella/solve/contact_problem.h>
#include <lamella/solve/state.h>

#include <vector>

namespace lamella
{
  /// Returns the normal and tangential forces of each constraint.
  std::vector<dealii::Tensor<1, 3>>
  forces_by_rows(const GapConstraints &rows, const State &state);

  /// Returns the slip v of constraint number @p r in the load step, with the
  /// compliance of its law (FrictionState).
  dealii::Tensor<1, 2>
  slip_in_step(const GapConstraint &row,
               const unsigned int   r,
               const State         &state,
               const LoadFactor    &factor);

  /// Adds the slips and shear forces of @p state to its @p problem.
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

  /// Returns the active gaps and slips of @p state as equations.
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
  /// [length]: |v| if it sticks, |v + |v| e| if it slips with shear along e.
  double
  friction_error(const GapConstraint &row,
                 const unsigned int   r,
                 const State         &state,
                 const LoadFactor    &factor);

  /// Updates FrictionState at the end of the step from @p before to @p state.
  void
  end_step(const GapConstraints &rows,
           const State          &before,
           const LoadFactor     &factor,
           State                &state);

  /// Updates FrictionState at the end of a load step of moving contacts, whose
  /// slips are zero at the beginning of the next step.
  void
  end_moved_step(const GapConstraints &rows,
                 const State          &before,
                 const LoadFactor     &factor,
                 State                &state);
} // namespace lamella

#endif
