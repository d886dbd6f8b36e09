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
  // Types of vectors and matrices. A vector of the whole scene has one block
  // per body. Contact couples bodies only through linear functionals; only the
  // solution strategy `full` assembles one matrix of all bodies.

  /// The number of a degree of freedom (DoF) within its body, from 0, with
  /// constrained DoFs included.
  using DofIndex = dealii::types::global_dof_index;

  /// Displacement vector u of one body, or the conjugate nodal force vector f,
  /// with one entry per DoF. Every process stores the whole vector.
  using Vector = dealii::Vector<double>;

  /// Displacements or nodal forces of all bodies, one block per body.
  using BlockVector = dealii::BlockVector<double>;

  /// Sparse matrix of one body on one process. It refers to its sparsity
  /// pattern, which must outlive the matrix.
  using Matrix = dealii::SparseMatrix<double>;

  /// Affine constraints u = G v + u_p, which express constrained DoFs of u by
  /// the unconstrained DoFs v. Call close() before use.
  using Constraints = dealii::AffineConstraints<double>;

  /// Distributed matrix: each process owns a contiguous range of rows. Only
  /// forward-declared, so that headers do not include Trilinos.
  using SharedMatrix = dealii::TrilinosWrappers::SparseMatrix;
  /// Distributed vector: each process owns a contiguous range of entries.
  using SharedVector = dealii::TrilinosWrappers::MPI::Vector;
} // namespace lamella

#endif
