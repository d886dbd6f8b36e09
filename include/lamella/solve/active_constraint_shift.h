// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_active_constraint_shift_h
#define lamella_solve_active_constraint_shift_h

#include <lamella/linear/stiffness_matrix.h>
#include <lamella/solve/contact_solver.h>

#include <vector>

namespace lamella
{
  /// Regularization of an indefinite tangent by springs in the active
  /// constraints, for bodies that only contact with obstacles keeps from
  /// buckling (a column behind a stop, a sheet between a pressure and a floor).
  /// The tangent K is not definite, but S = K + rho B^T B is, with a spring of
  /// stiffness rho in each active constraint and their rows B.
  ///
  /// With the shifted forces lambda' = lambda + rho g, the increment x from a
  /// state with gaps g_0 and residual forces r,
  ///   K x = r + B^T (lambda - lambda_0),   lambda = -eps g,
  /// equals that of
  ///   S x = r + B^T (lambda' - lambda'_0),   lambda' = -(eps - rho) g,
  /// as long as the constraint is active: a contact problem whose S has a
  /// Cholesky factor. If a constraint opens, x has an error due to the spring
  /// force, which the next iteration corrects. rho is a fraction of the penalty
  /// eps. If S is definite, the state is stable.
  class ActiveConstraintShift
  {
  public:
    /// Springs of each body.
    using Springs = std::vector<std::vector<SpringTerm>>;

    /// Adds a spring to each active constraint of @p state in @p contacts of
    /// @p n_bodies bodies. rho is @p share times the penalty eps.
    ActiveConstraintShift(const std::vector<ContactInterface> &contacts,
                          const State                         &state,
                          const unsigned int                   n_bodies,
                          const double                         share);

    bool
    none() const
    {
      return shift.empty();
    }

    const Springs &
    springs() const
    {
      return of_bodies;
    }

    /// Returns all constraints; those with a spring have the penalty eps - rho.
    GapConstraints
    rows() const
    {
      return GapConstraints(softened);
    }

    /// Replaces the forces of @p state, with the displacements @p u at load
    /// factor @p factor, by lambda'; apply_shift() is the inverse. Tensile
    /// constraints are deactivated.
    void
    remove_shift(const BlockVector &u,
                 const LoadFactor  &factor,
                 State             &state) const;
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
