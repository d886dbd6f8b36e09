// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_active_constraint_shift_h
#define lamella_solve_active_constraint_shift_h

#include <lamella/linear/stiffness_matrix.h>
#include <lamella/solve/contact_solver.h>

#include <vector>

namespace lamella
{
  /// Regularization of an indefinite tangent stiffness K by springs in the
  /// active constraints. Bodies need it that would buckle without their contact
  /// with obstacles (a column behind a stop). S = K + rho B^T B is definite,
  /// with the active constraint rows B and a spring of stiffness rho in each.
  ///
  /// With the gaps g, penalty eps, contact forces lambda and shifted forces
  /// lambda' = lambda + rho g, the increment x from a state (index 0) with
  /// residual r,
  ///   K x = r + B^T (lambda - lambda_0),   lambda = -eps g,
  /// equals that of
  ///   S x = r + B^T (lambda' - lambda'_0),   lambda' = -(eps - rho) g,
  /// as long as the constraints are active. If a constraint opens, x has an
  /// error due to the spring force, which the next iteration corrects. rho is a
  /// fraction of eps. If S is definite, the state is stable.
  class ActiveConstraintShift
  {
  public:
    /// Springs to the ground, one list per body.
    using Springs = std::vector<std::vector<SpringTerm>>;

    /// Adds a spring to each active constraint of a body with an obstacle that
    /// has a force in @p state. Its stiffness is @p share times the penalty.
    ActiveConstraintShift(const std::vector<ContactInterface> &contacts,
                          const State                         &state,
                          const unsigned int                   n_bodies,
                          const double                         share);

    /// Returns true if no constraint has a spring.
    bool
    none() const
    {
      return shift.empty();
    }

    /// Returns the springs of all bodies, to be added to the tangent stiffness.
    const Springs &
    springs() const
    {
      return of_bodies;
    }

    /// Returns all constraints; springs are subtracted from their penalties.
    GapConstraints
    rows() const
    {
      return GapConstraints(softened);
    }

    /// Adds spring stiffness times gap to the force of each constraint with a
    /// spring, for the displacements @p u at load factor @p factor.
    void
    remove_shift(const BlockVector &u,
                 const LoadFactor  &factor,
                 State             &state) const;
    void
    /// Inverse of remove_shift(). Also deactivates constraints without force.
    apply_shift(const BlockVector &u,
                const LoadFactor  &factor,
                State             &state) const;

  private:
    struct ShiftedConstraint
    {
      unsigned int row;
      double       spring;
    };
    std::vector<ShiftedConstraint> shift;
    Springs                        of_bodies;
    std::vector<ContactInterface>  softened;
  };
} // namespace lamella

#endif
