// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_active_constraint_shift_h
#define lamella_solve_active_constraint_shift_h

#include <lamella/linear/stiffness_matrix.h>
#include <lamella/solve/contact_solver.h>

#include <vector>

namespace lamella
{
  /**
   * Active constraints against obstacles, used to make the tangent definite for
   * bodies that only they keep from buckling (a column behind a stop, a sheet
   * between a pressure and a floor). The tangent K is not definite, but with a
   * spring rho in each constraint, S = K + rho B^T B, it is.
   *
   * With shifted forces lambda' = lambda + rho g, the increment x from a state
   * with gaps g_0,
   *   K x = r + B^T (lambda - lambda_0),   lambda = -eps g,
   * is that of
   *   S x = r + B^T (lambda' - lambda'_0),   lambda' = -(eps - rho) g,
   * as long as the constraint is active: a contact problem whose S has a
   * Cholesky factor. If a constraint opens, x is off by the spring force, which
   * the next iteration corrects. rho is a share of the penalty eps; a smaller
   * one leaves less rounding in the forces. Constraints without a penalty law
   * keep their numerical penalty. A definite S implies that the state is stable
   * as long as these constraints are active.
   */
  class ActiveConstraintShift
  {
  public:
    /// Springs of each body.
    using Springs = std::vector<std::vector<SpringTerm>>;

    /// Selects active constraints of @p state among the rows of @p contacts for
    /// @p n_bodies bodies, with rho = @p share times eps.
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

    /// Returns all rows; shifted ones have the remaining penalty.
    GapConstraints
    rows() const
    {
      return GapConstraints(softened);
    }

    /// Replaces the forces of @p state, displaced to @p u at @p factor, by
    /// lambda', and back; tensile rows are deactivated.
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
