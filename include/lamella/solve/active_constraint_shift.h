// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_active_constraint_shift_h
#define lamella_solve_active_constraint_shift_h

#include <lamella/linear/stiffness_matrix.h>
#include <lamella/solve/state.h>

#include <vector>

namespace lamella
{
  /// Regularization of an indefinite tangent stiffness K by springs in the
  /// active constraints, for bodies that would buckle without their contact
  /// with an obstacle (a column beside a stop). S = K + rho B^T B is definite,
  /// with the rows B of active constraints and a spring of stiffness rho in
  /// each.
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

    /// Adds a spring, with @p share times the penalty as stiffness, to each
    /// constraint on an obstacle that has a contact force in @p state.
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

    /// Returns all constraints, with penalties reduced by their springs.
    GapConstraints
    rows() const
    {
      return GapConstraints(softened);
    }

    /// Replaces the forces lambda of constraints with a spring by the shifted
    /// forces lambda', for the gaps at displacements @p u and load factor @p
    /// factor.
    void
    remove_shift(const BlockVector &u,
                 const LoadFactor  &factor,
                 State             &state) const;
    /// Replaces lambda' by lambda again; deactivates constraints without force.
    void
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
