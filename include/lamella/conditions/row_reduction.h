// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_row_reduction_h
#define lamella_conditions_row_reduction_h

#include <lamella/conditions/support.h>

#include <deal.II/lac/sparse_direct.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * The prescribed rows R u = d of one body, reduced to
   * u = G v + u_p with the unconstrained DoFs v, together with the body's own
   * kinematic constraints, which come first: as many DoFs are eliminated as
   * rows are independent (Gauss-Jordan elimination of the rows of each group
   * that shares DoFs, with rank detection). Coarse DoFs go first, so that what
   * stays is still hierarchical; among rows with a pivot within a factor of ten
   * of the largest the shortest is taken, which keeps the fill low. A group
   * that is the one before it, shifted along the axis, is not eliminated again.
   */
  class RowReduction
  {
  public:
    /**
     * Takes those of @p rows that belong to @p body, number @p index. Throws
     * InputError if rows contradict each other; @p support_names then name
     * them.
     */
    RowReduction(const Body                       &body,
                 const unsigned int                index,
                 const std::vector<PrescribedRow> &rows,
                 const std::vector<std::string>   &support_names);

    /// u = G v, for load factor 0.
    const Constraints &
    constraints() const
    {
      return homogeneous;
    }

    /// u_p at load factor 1: non-zero in constrained DoFs only.
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
     */
    std::vector<std::pair<unsigned int, double>>
    multipliers(const Vector &residual) const;

  private:
    /// The independent rows of a group and the DoFs that they eliminate.
    struct Group
    {
      std::vector<unsigned int> rows;
      std::vector<DofIndex>     pivots;
      /// The factorised transpose of the rows in the pivots' columns; groups
      /// that are the same but for a shift share it.
      std::shared_ptr<const dealii::SparseDirectUMFPACK> transposed;
    };

    struct Equation;
    struct Elimination;

    /// Eliminates one group of rows (numbers in the constructor's list), given
    /// as @p functionals of the DoFs that the theory leaves independent.
    static Elimination
    eliminate(const Body                       &body,
              const std::vector<unsigned int>  &group,
              const std::vector<Row>           &functionals,
              const std::vector<PrescribedRow> &rows);

    /// Keeps what is left of a group as constraints. Throws InputError if
    /// nothing but a value is left of one of its rows.
    void
    keep(const Elimination                &elimination,
         const Body                       &body,
         const std::vector<PrescribedRow> &rows,
         const std::vector<std::string>   &support_names);

    /// Factorises the rows of @p independent, for multipliers().
    static void
    factorise(Group &independent, const std::vector<Row> &functionals);

    const Constraints &kinematic;
    Constraints        homogeneous;
    Vector             particular_solution;
    std::vector<Group> groups;
  };
} // namespace lamella

#endif
