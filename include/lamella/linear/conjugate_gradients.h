// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_conjugate_gradients_h
#define lamella_linear_conjugate_gradients_h

#include <lamella/linear/linear_solver.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace lamella
{
  /**
   * Conjugate gradients with ML's smoothed aggregation, for matrices of nodal
   * displacements: its memory and work grow with the DoFs only. Coarse levels
   * keep the @p near_null_space, whole vectors that vanish in constrained DoFs.
   * Each right-hand side takes its own iterations, so contact with many rows is
   * expensive.
   *
   * Convergence is asked for as |b - A x| <= 1e-11 |b| within 2000 iterations,
   * otherwise NumericsError, which names @p what. Chebyshev smoothing, and a
   * direct solution on the coarsest level of at most 300 unknowns. Six vectors
   * are taken for the rigid motions of nodes with three DoFs each, which then
   * stay together when they are aggregated.
   *
   * The solver shares the ownership of @p matrix; what it needs of the vectors
   * is copied. There is no condition estimate. Its solved rows are RowProducts,
   * a whole solution a row. Collective, as are all functions of the result.
   */
  std::unique_ptr<LinearSolver>
  iterate(std::shared_ptr<const SharedMatrix> matrix,
          const std::vector<Vector>          &near_null_space,
          const std::string                  &what);
} // namespace lamella

#endif
