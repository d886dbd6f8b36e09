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
   * The prescribed rows R u = d of one body, reduced to u = G v + u_p with the
   * unconstrained DoFs v, together with the body's own kinematic constraints,
   * which come first: as many DoFs are eliminated as rows are independent
   * (Gauss-Jordan elimination of the rows of each group that shares DoFs, with
   * rank detection). Coarse DoFs go first, so that what stays is still
   * hierarchical, each with a row in which it is a tenth of the largest weight
   * or more; among rows with a pivot within a factor of ten of the largest the
   * shortest is taken, which keeps the fill low. A group that is the one before
   * it, shifted along the axis, is not eliminated again.
   *
   *   R = P (pivot columns) + Q (others),  u_P = P^-1 d - P^-1 Q u_Q:
   *
   * the elimination leaves these equations as lines of constraints. Exact to
   * rounding, without a penalty. Rows may depend on each other; what is left of
   * a dependent one must be 0 = 0. A row depends on others where less than 1e-6
   * of its largest weight is left, DoFs measured by the displacements that they
   * make (Body::dof_sizes()): the points of a line that runs as near as that to
   * a line of the mesh hold what those on it do, and displacements there are
   * prescribed to 1e-6 of those around. A value below 1e-6 of the largest is
   * agreement.
   *
   * Refers to the kinematic constraints of its body, which must outlive it. All
   * processes compute all of it.
   */
  class RowReduction
  {
  public:
    /**
     * Takes those of @p rows that belong to @p body, number @p index. Throws
     * InputError if rows contradict each other; @p support_names then name
     * them. @p rows may be those of all bodies. @p support_names are the names
     * of supports by PrescribedRow::support. Each row must name a DoF once
     * (Row::compress()).
     */
    RowReduction(const Body                       &body,
                 const unsigned int                index,
                 const std::vector<PrescribedRow> &rows,
                 const std::vector<std::string>   &support_names);

    /// u = G v, for load factor 0. Supports and kinematic constraints together,
    /// closed and homogeneous: what the stiffness is condensed by and solutions
    /// are distributed with.
    const Constraints &
    constraints() const
    {
      return homogeneous;
    }

    /// u_p at load factor 1: non-zero in constrained DoFs only. Times the load
    /// factor s of the step it satisfies R u = s d and the kinematic
    /// constraints, whatever its energy.
    const Vector &
    particular() const
    {
      return particular_solution;
    }

    /**
     * The forces mu in the rows that hold a body with unbalanced forces
     * @p residual (internal minus external): residual = R^T mu. Pairs of the
     * row's number in the rows given to the constructor and its force, on the
     * body, in the direction of the row's component. Rows that depend on others
     * have none: the multipliers of dependent rows are not unique, their
     * resultants are.
     *
     * In the independent rows R_P^T mu = residual_P, pivots only, with the
     * residual condensed by the kinematic constraints first: one solution with
     * a sparse LU factor a group. Reactions are their sums; a moment is that of
     * forces at the rows' positions.
     */
    std::vector<std::pair<unsigned int, double>>
    multipliers(const Vector &residual) const;

    /**
     * The transpose of multipliers(): a displacement w with
     *   sum_k weight(k) mu_k = w . residual,
     * k the number of the row in those given to the constructor. It is the
     * displacement, zero in all DoFs that no row eliminates, that the
     * independent rows measure as their weights: what a support that moves like
     * this does work on.
     */
    Vector
    influence(const std::function<double(const unsigned int)> &weight) const;

  private:
    /// Keeps what is left of a group as constraints. Throws InputError if
    /// nothing but a value is left of one of its rows.
    void
    keep(const RowElimination             &elimination,
         const Body                       &body,
         const std::vector<PrescribedRow> &rows,
         const std::vector<std::string>   &support_names);

    /// Of the body; then supports and these together, and u_p for all its DoFs.
    const Constraints           &kinematic;
    Constraints                  homogeneous;
    Vector                       particular_solution;
    std::vector<IndependentRows> groups;
  };
} // namespace lamella

#endif
