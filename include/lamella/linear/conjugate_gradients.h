// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_conjugate_gradients_h
#define lamella_linear_conjugate_gradients_h

#include <lamella/linear/linear_solver.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace lamella
{
  /// Returns a conjugate gradient solver for stiffness matrices of nodal
  /// displacements, preconditioned by the smoothed aggregation multigrid of
  /// Trilinos ML. Memory and work are proportional to the number of DoFs.
  /// Coarse levels preserve the vectors @p near_null_space (such as rigid-body
  /// motions), which must be zero in constrained DoFs. If there are six, they
  /// must be the rigid-body motions of nodes with three DoFs each.
  ///
  /// The iteration for A x = b ends if |b - A x| <= 1e-11 |b|. Throws
  /// NumericsError, with @p what as name of A, if this takes more than 2000
  /// iterations. The smoother is Chebyshev's; the coarsest level of at most 300
  /// unknowns is solved directly. Shares the ownership of @p matrix. There is
  /// no condition estimate. Collective, as are all functions of the solver.
  std::unique_ptr<LinearSolver>
  make_conjugate_gradients(std::shared_ptr<const SharedMatrix> matrix,
                           const std::vector<Vector>          &near_null_space,
                           const std::string                  &what);
} // namespace lamella

#endif
