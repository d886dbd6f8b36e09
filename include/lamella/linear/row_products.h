// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_row_products_h
#define lamella_linear_row_products_h

#include <lamella/linear/linear_solver.h>

namespace lamella
{
  /**
   * Solved rows of a solver that has no halves: what is kept of A^-1 B^T is
   * B A^-1 B^T alone, and a displacement is one more solution. By symmetry the
   * columns that are solved for now give the products with all rows before, so
   * that no column need be kept.
   */
  class RowProducts : public SolvedRows
  {
  public:
    /// Returns b_j A^-1 b_i of all given rows j with the rows i from the number
    /// on, at [(i - number) * number of rows + j].
    using Solve =
      std::function<std::vector<double>(const std::vector<Row> &rows,
                                        const unsigned int      first)>;

    /// @p solver, of @p n_dofs unknowns, is referred to.
    RowProducts(const LinearSolver &solver, const DofIndex n_dofs, Solve solve);

    void
    append(const std::vector<Row> &rows) override;

    unsigned int
    size() const override
    {
      return rows.size();
    }

    std::vector<double>
    products(const unsigned int first) const override;

    Vector
    displacement(const std::vector<double> &lambda) const override;

  private:
    const LinearSolver &solver;
    DofIndex            n_dofs;
    Solve               solve;
    std::vector<Row>    rows;
    /// Of each row with those that were there when it was appended.
    std::vector<std::vector<double>> kept;
  };
} // namespace lamella

#endif
