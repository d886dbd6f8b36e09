// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_friction_step_h
#define lamella_solve_friction_step_h

#include <lamella/solve/contact_problem.h>
#include <lamella/solve/state.h>

#include <vector>

namespace lamella
{
  /// Returns the contact forces of all constraints along normal and tangents.
  std::vector<dealii::Tensor<1, 3>>
  forces_by_rows(const GapConstraints &rows, const State &state);

  /// Returns the slip of the constraint @p row, of index @p r, since the start
  /// of the load step, including the elastic slip of a penalty [length].
  dealii::Tensor<1, 2>
  slip_in_step(const GapConstraint &row,
               const unsigned int   r,
               const State         &state,
               const LoadFactor    &factor);

  /// Adds the friction data of @p state to @p problem: slips in the load step,
  /// without elastic slip, and contact forces.
  void
  add_friction(const GapConstraints &rows,
               const State          &state,
               const LoadFactor     &factor,
               ContactProblem       &problem);

  /// Copies forces, slip directions and active set of @p found to @p state.
  void
  store_forces(const GapConstraints  &rows,
               const ContactSolution &found,
               State                 &state);

  /// Returns the equations of the active constraints of @p state: zero gap and
  /// zero slip if they stick, zero gap only if they slip.
  ActiveConstraints
  active_equations(const GapConstraints &rows, const State &state);

  /// Adds the force increments @p dlambda of the equations @p closed to the
  /// forces of @p state. Shear forces of slipping constraints follow from the
  /// friction coefficient and the new normal force.
  void
  add_forces(const GapConstraints    &rows,
             const ActiveConstraints &closed,
             const Vector            &dlambda,
             State                   &state);

  /// Returns the error of Coulomb's law at the active constraint @p row, of
  /// index @p r: |v| if it sticks, |v + |v| e| if it slips, with the slip v in
  /// the load step and the unit vector e along the shear force [length]. Zero
  /// if the cosine of the angle between e and -v rounds to 1.
  double
  friction_error(const GapConstraint &row,
                 const unsigned int   r,
                 const State         &state,
                 const LoadFactor    &factor);

  /// Updates the friction history of @p state at the end of a load step. If the
  /// constraints @p rows follow the bodies, @p moves is true: slips are
  /// measured from the beginning of the step, and points may have lost their
  /// constraint.
  void
  end_step(const GapConstraints &rows,
           const LoadFactor     &factor,
           const bool            moves,
           State                &state);
} // namespace lamella

#endif
