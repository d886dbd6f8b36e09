// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_linear_algebra_h
#define lamella_base_linear_algebra_h

#include <deal.II/base/types.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/block_vector.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/vector.h>

namespace dealii::TrilinosWrappers
{
  class SparseMatrix;
  namespace MPI
  {
    class Vector;
  }
} // namespace dealii::TrilinosWrappers

namespace lamella
{
  // The linear algebra of the program. A vector of the scene has one block per
  // body. Contact couples bodies only through linear functionals; only the
  // strategy `full` has a matrix of the whole scene.

  /// The number of a DoF within its body, from 0; constrained DoFs count.
  using DofIndex = dealii::types::global_dof_index;

  /// A number per DoF of one body, whole on every process: displacements u or
  /// forces f, conjugate to each other, so that f . u is a work.
  using Vector = dealii::Vector<double>;

  /// A Vector per body, in the order of the scene's Bodies.
  using BlockVector = dealii::BlockVector<double>;

  /// A sparse matrix of one body on one process; refers to its SparsityPattern.
  using Matrix = dealii::SparseMatrix<double>;

  /// u = G v + u_p: a DoF as an affine combination of others. Call close()
  /// before any use.
  using Constraints = dealii::AffineConstraints<double>;

  /// Matrix and vector that processes share, each with a contiguous range of
  /// rows (base/processes.h). Only declared, so that headers need no Trilinos.
  using SharedMatrix = dealii::TrilinosWrappers::SparseMatrix;
  using SharedVector = dealii::TrilinosWrappers::MPI::Vector;
} // namespace lamella

#endif
