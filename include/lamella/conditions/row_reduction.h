// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_row_reduction_h
#define lamella_conditions_row_reduction_h

#include <lamella/conditions/row_elimination.h>
#include <lamella/conditions/support.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /**
   * Reduction of the prescribed rows R u = d of one body, together with its
   * kinematic constraints (which come first), to u = G v + u_p with the
   * unconstrained DoFs v. Gauss-Jordan elimination with rank detection, in each
   * group of rows that shares DoFs, eliminates one DoF per independent row:
   *   R = P (pivot columns) + Q (others),  u_P = P^-1 d - P^-1 Q u_Q,
   * exact to rounding, without a penalty. Coarse DoFs are eliminated first, so
   * that the rest stays hierarchical. A pivot has at least a tenth of its row's
   * largest weight; among rows with a pivot within a factor of ten of the
   * largest, the shortest is taken, which limits fill. A group that is its
   * predecessor shifted along the axis is not eliminated again.
   *
   * A row is dependent if less than 1e-6 of its largest weight remains, with
   * DoFs scaled by their displacements (Body::dof_scales()): a line of points
   * that close to a mesh line fixes the same DoFs. Its value must agree to 1e-6
   * of the largest. Keeps a reference to the kinematic constraints of its body.
   */
  class RowReduction
  {
  public:
    /// Reduces the @p rows of @p body, number @p index, others are ignored.
    /// Each row must name a DoF once. Throws InputError with @p support_names
    /// if rows contradict each other.
    RowReduction(const Body                              &body,
                 const unsigned int                       index,
                 const std::vector<PrescribedFunctional> &rows,
                 const std::vector<std::string>          &support_names);

    /// Returns the closed homogeneous constraints u = G v of supports and
    /// theory, which condense the stiffness and distribute solutions.
    const Constraints &
    constraints() const
    {
      return homogeneous;
    }

    /// Returns u_p at load factor 1, zero in unconstrained DoFs. Times the load
    /// factor s it satisfies R u = s d.
    const Vector &
    particular() const
    {
      return particular_solution;
    }

    /// Returns the multipliers mu, residual = R^T mu, that balance the forces
    /// @p residual (internal minus external): pairs of the row's number and its
    /// force on the body. Dependent rows have none: their multipliers are not
    /// unique, but resultants are. R_P^T mu = residual_P is solved in the
    /// pivots, with the residual condensed by the kinematic constraints, by one
    /// sparse LU factor per group.
    std::vector<std::pair<unsigned int, double>>
    multipliers(const Vector &residual) const;

    /// Returns the transpose of multipliers(): a displacement w, zero in DoFs
    /// that no row eliminates, with
    ///   sum_k weight(k) mu_k = w . residual,   k the number of the row.
    Vector
    influence(const std::function<double(const unsigned int)> &weight) const;

  private:
    /// Stores the rest of a group as constraints; throws InputError for 0 = 1.
    void
    keep(const RowElimination                    &elimination,
         const Body                              &body,
         const std::vector<PrescribedFunctional> &rows,
         const std::vector<std::string>          &support_names);

    /// Constraints of the body; those with supports; u_p for all its DoFs.
    const Constraints           &kinematic;
    Constraints                  homogeneous;
    Vector                       particular_solution;
    std::vector<IndependentRows> groups;
  };
} // namespace lamella

#endif
