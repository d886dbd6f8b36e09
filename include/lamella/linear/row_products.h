// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_row_products_h
#define lamella_linear_row_products_h

#include <lamella/linear/linear_solver.h>

namespace lamella
{
  /// SolvedRows of solvers without a factor L of A (MUMPS, conjugate
  /// gradients). Stores only the compliance B A^-1 B^T of constraint rows B, so
  /// displacement() solves again. m rows take m solutions and 4 m^2 bytes.
  class RowProducts : public SolvedRows
  {
  public:
    /// Function that returns b_j A^-1 b_i for all @p rows j and the rows i >=
    /// @p first, at [(i - first) * n_rows + j].
    using Solve = std::function<
      std::vector<double>(const std::vector<LinearFunctional> &rows,
                          const unsigned int                   first)>;

    /// Keeps a reference to @p solver, of @p n_dofs unknowns, which must
    /// outlive this object.
    RowProducts(const LinearSolver &solver, const DofIndex n_dofs, Solve solve);

    /// Appends @p rows and computes their products by one call of Solve.
    void
    append(const std::vector<LinearFunctional> &rows) override;

    /// Returns the number of appended rows.
    unsigned int
    size() const override
    {
      return rows.size();
    }

    std::vector<double>
    products(const unsigned int first) const override;

    /// Returns A^-1 B^T @p lambda by one solution with A.
    Vector
    displacement(const std::vector<double> &lambda) const override;

  private:
    /// Solver, which must outlive this object.
    const LinearSolver &solver;
    DofIndex            n_dofs;
    Solve               solve;
    /// Rows in the order of appending.
    std::vector<LinearFunctional> rows;
    /// Products kept[i][j] = b_j A^-1 b_i of each row i with all rows j that
    /// were appended before or together with row i.
    std::vector<std::vector<double>> kept;
  };
} // namespace lamella

#endif
