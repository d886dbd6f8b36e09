// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_friction_step_h
#define lamella_solve_friction_step_h

#include <lamella/solve/contact_problem.h>
#include <lamella/solve/state.h>

#include <vector>

namespace lamella
{
  /// Of each row the normal force and the shear along its tangents.
  std::vector<dealii::Tensor<1, 3>>
  forces_by_rows(const GapRows &rows, const State &state);

  /// v of the row number @p r: its slip in the step, with the softness of the
  /// law.
  dealii::Tensor<1, 2>
  slip_in_step(const GapRow      &row,
               const unsigned int r,
               const State       &state,
               const LoadFactor  &factor);

  /// Adds to the @p problem about @p state, which has friction, slips and
  /// shears; the search begins with the forces of the state.
  void
  add_friction(const GapRows    &rows,
               const State      &state,
               const LoadFactor &factor,
               ContactProblem   &problem);

  /// Gives @p state the forces that a strategy @p found.
  void
  take_forces(const GapRows &rows, const ContactSolution &found, State &state);

  /// What does not move in @p state.
  ClosedRows
  closed_rows(const GapRows &rows, const State &state);

  /// Adds @p dlambda to the forces of @p state; of rows that slip the shear
  /// follows.
  void
  add_forces(const GapRows    &rows,
             const ClosedRows &closed,
             const Vector     &dlambda,
             State            &state);

  /// By how far @p state, with friction, misses the law of row @p r, which
  /// bears a force: |v| where it sticks, |v + |v| e| where it slips along
  /// -e [length].
  double
  friction_error(const GapRow      &row,
                 const unsigned int r,
                 const State       &state,
                 const LoadFactor  &factor);

  /// Ends the load step that has come from @p before to @p state at @p factor:
  /// what friction remembers of it (FrictionState). Nothing without.
  void
  end_step(const GapRows    &rows,
           const State      &before,
           const LoadFactor &factor,
           State            &state);

  /// The same of rows that move: the next step's slips begin at zero, and no
  /// balance of work is kept.
  void
  end_moved_step(const GapRows    &rows,
                 const State      &before,
                 const LoadFactor &factor,
                 State            &state);
} // namespace lamella

#endif
