// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_conjugate_gradients_h
#define lamella_linear_conjugate_gradients_h

#include <lamella/linear/linear_solver.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace lamella
{
  /**
   * Returns a solver by conjugate gradients with ML's smoothed aggregation, for
   * matrices of nodal displacements; memory and work are proportional to the
   * DoFs. Coarse levels preserve the @p near_null_space, whole vectors that
   * vanish in constrained DoFs. Each right-hand side is iterated separately.
   *
   * The tolerance is |b - A x| <= 1e-11 |b| within 2000 iterations; otherwise
   * throws NumericsError, which names @p what. Chebyshev smoothing, and a
   * direct solution on the coarsest level of at most 300 unknowns. Six vectors
   * are interpreted as the rigid motions of nodes with three DoFs each. Shares
   * the ownership of @p matrix. No condition estimate. Collective, as are all
   * functions of the result.
   */
  std::unique_ptr<LinearSolver>
  make_conjugate_gradients(std::shared_ptr<const SharedMatrix> matrix,
                           const std::vector<Vector>          &near_null_space,
                           const std::string                  &what);
} // namespace lamella

#endif
