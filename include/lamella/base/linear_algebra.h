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
  // The one place that decides the linear algebra of the program. A vector of
  // the whole scene has one block per body: contact couples bodies only through
  // rows, so no matrix of the whole scene exists outside the `full` strategy.
  using DofIndex    = dealii::types::global_dof_index;
  using Vector      = dealii::Vector<double>;
  using BlockVector = dealii::BlockVector<double>;
  using Matrix      = dealii::SparseMatrix<double>;
  using Constraints = dealii::AffineConstraints<double>;

  // What several processes share, by rows (base/processes.h).
  using SharedMatrix = dealii::TrilinosWrappers::SparseMatrix;
  using SharedVector = dealii::TrilinosWrappers::MPI::Vector;
} // namespace lamella

#endif
