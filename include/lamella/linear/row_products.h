// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_row_products_h
#define lamella_linear_row_products_h

#include <lamella/linear/linear_solver.h>

namespace lamella
{
  /**
   * Solved rows of a solver that has no halves: what is kept of A^-1 B^T is B
   * A^-1 B^T alone, and a displacement is one more solution. By symmetry the
   * columns that are solved for now give the products with all rows before, so
   * that no column need be kept.
   *
   * So m rows cost m solutions and m^2/2 numbers, 8 bytes each, on every
   * process, where whole columns would take m times the DoFs. Used by MUMPS,
   * which solves for many sparse right-hand sides at a time, and by conjugate
   * gradients, which solve for one after the other.
   */
  class RowProducts : public SolvedRows
  {
  public:
    /// Returns b_j A^-1 b_i of all given rows j with the rows i from the number
    /// on, at [(i - number) * number of rows + j]. Must be collective if the
    /// solver is, and return the same on all processes.
    using Solve =
      std::function<std::vector<double>(const std::vector<Row> &rows,
                                        const unsigned int      first)>;

    /// @p solver, of @p n_dofs unknowns, is referred to. @p solve usually
    /// captures that solver, too.
    RowProducts(const LinearSolver &solver, const DofIndex n_dofs, Solve solve);

    /// Calls Solve once, for all of @p rows together with those that are there.
    void
    append(const std::vector<Row> &rows) override;

    /// The number of rows appended so far.
    unsigned int
    size() const override
    {
      return rows.size();
    }

    std::vector<double>
    products(const unsigned int first) const override;

    /// Costs one solution; exact as that solution is, whatever was kept.
    Vector
    displacement(const std::vector<double> &lambda) const override;

  private:
    /// Referred to: it outlives the rows that it hands out.
    const LinearSolver &solver;
    DofIndex            n_dofs;
    Solve               solve;
    /// All rows given, in their order.
    std::vector<Row> rows;
    /// Of each row with those that were there when it was appended. kept[i][j]
    /// = b_j A^-1 b_i for all j up to the end of i's batch: the lower triangle,
    /// and a little more within a batch.
    std::vector<std::vector<double>> kept;
  };
} // namespace lamella

#endif
