// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_row_products_h
#define lamella_linear_row_products_h

#include <lamella/linear/linear_solver.h>

namespace lamella
{
  /// Compliance B A^-1 B^T of constraints for solvers without a factor of the
  /// matrix A (MUMPS, conjugate gradients). m constraints take m solutions and
  /// 4 m^2 bytes. Each call of displacement() takes one more solution.
  class RowProducts : public SolvedRows
  {
  public:
    /// Function that returns the compliance b_j A^-1 b_i for all @p rows b_j
    /// and the rows b_i with i >= @p first, at [(i - first) * n_rows + j].
    using Solve = std::function<
      std::vector<double>(const std::vector<LinearFunctional> &rows,
                          const unsigned int                   first)>;

    /// Keeps a reference to @p solver, which has @p n_dofs unknowns.
    RowProducts(const LinearSolver &solver, const DofIndex n_dofs, Solve solve);

    /// Appends the constraints @p added and computes their compliances.
    void
    append(const std::vector<LinearFunctional> &added) override;

    /// Returns the number of appended constraints.
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
    const LinearSolver &solver; ///< Solver, which must outlive this object.
    DofIndex            n_dofs;
    Solve               solve;
    std::vector<LinearFunctional> rows; ///< Constraints in appended order.
    /// Compliances kept[i][j] = b_j A^-1 b_i of each constraint i with all
    /// constraints j that were appended before or together with i.
    std::vector<std::vector<double>> kept;
  };
} // namespace lamella

#endif
