// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_friction_step_h
#define lamella_solve_friction_step_h

#include <lamella/solve/contact_problem.h>
#include <lamella/solve/state.h>

#include <vector>

namespace lamella
{
  /// Returns the normal force and the shear force along the tangents by rows.
  std::vector<dealii::Tensor<1, 3>>
  forces_by_rows(const GapConstraints &rows, const State &state);

  /// Returns the slip v of row @p r in the step, with the law's compliance.
  dealii::Tensor<1, 2>
  slip_in_step(const GapConstraint &row,
               const unsigned int   r,
               const State         &state,
               const LoadFactor    &factor);

  /// Adds slips and shear forces to @p problem about @p state, its start.
  void
  add_friction(const GapConstraints &rows,
               const State          &state,
               const LoadFactor     &factor,
               ContactProblem       &problem);

  /// Stores the forces @p found by a strategy in @p state.
  void
  store_forces(const GapConstraints  &rows,
               const ContactSolution &found,
               State                 &state);

  /// Returns the closed constraints of @p state.
  ActiveConstraints
  active_equations(const GapConstraints &rows, const State &state);

  /// Adds @p dlambda to the forces of @p state; slipping shear forces follow.
  void
  add_forces(const GapConstraints    &rows,
             const ActiveConstraints &closed,
             const Vector            &dlambda,
             State                   &state);

  /// Returns the friction error of the active row @p r in @p state [length]:
  /// |v| if it sticks, |v + |v| e| if it slips along -e.
  double
  friction_error(const GapConstraint &row,
                 const unsigned int   r,
                 const State         &state,
                 const LoadFactor    &factor);

  /// Ends the load step from @p before at @p factor by updating FrictionState.
  void
  end_step(const GapConstraints &rows,
           const State          &before,
           const LoadFactor     &factor,
           State                &state);

  /// Ends the load step of moving contacts; the next slips start at zero.
  void
  end_moved_step(const GapConstraints &rows,
                 const State          &before,
                 const LoadFactor     &factor,
                 State                &state);
} // namespace lamella

#endif
