// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_row_products_h
#define lamella_linear_row_products_h

#include <lamella/linear/linear_solver.h>

namespace lamella
{
  /// Solved rows of a solver without half solutions (MUMPS, conjugate
  /// gradients). It stores B A^-1 B^T only; a displacement takes another
  /// solution. m rows cost m solutions and m^2/2 numbers, 8 bytes each, on
  /// every process.
  class RowProducts : public SolvedRows
  {
  public:
    /// Returns b_j A^-1 b_i of all given rows j and the rows i from @p first
    /// on, at [(i - first) * number of rows + j]. Collective if the solver is.
    using Solve = std::function<
      std::vector<double>(const std::vector<LinearFunctional> &rows,
                          const unsigned int                   first)>;

    /// Refers to @p solver, of @p n_dofs unknowns.
    RowProducts(const LinearSolver &solver, const DofIndex n_dofs, Solve solve);

    /// Calls Solve once, for @p rows with all earlier ones.
    void
    append(const std::vector<LinearFunctional> &rows) override;

    /// Returns the number of rows appended so far.
    unsigned int
    size() const override
    {
      return rows.size();
    }

    std::vector<double>
    products(const unsigned int first) const override;

    /// Costs one solution.
    Vector
    displacement(const std::vector<double> &lambda) const override;

  private:
    /// Solver, which outlives its rows.
    const LinearSolver &solver;
    DofIndex            n_dofs;
    Solve               solve;
    /// Rows in the order of appending.
    std::vector<LinearFunctional> rows;
    /// Products of each row with those up to the end of its batch: kept[i][j] =
    /// b_j A^-1 b_i, the lower triangle and more.
    std::vector<std::vector<double>> kept;
  };
} // namespace lamella

#endif
