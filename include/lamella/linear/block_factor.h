// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_block_factor_h
#define lamella_linear_block_factor_h

#include <lamella/linear/block_pattern.h>
#include <lamella/linear/forward_solved_rows.h>

#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// The Cholesky factor L of A = P^T L L^T P with a permutation P, stored by
  /// dense blocks with the sparsity of a BlockPattern. The lower triangle of A
  /// is assembled into the storage of L and factorized in place by a
  /// right-looking algorithm (factorize_blocks()).
  class BlockFactor
  {
  public:
    /// Stores the @p pattern without allocating the entries of L.
    explicit BlockFactor(BlockPattern pattern);

    /// Returns the sparsity pattern and elimination order of L.
    const BlockPattern &
    where() const
    {
      return pattern;
    }

    /// Allocates zero entries of L. May throw std::bad_alloc.
    void
    allocate();
    /// Returns a pointer p to the entries of A in the column of DoF @p column
    /// and the rows of @p block, so that p[i] is the entry in row i; nullptr if
    /// they are above the diagonal. @p column and @p block must be coupled.
    double *
    column_begin(const DofIndex column, const unsigned int block);
    /// Returns the diagonal entry of A in the row of DoF @p dof.
    double &
    diagonal(const DofIndex dof);

    /// Replaces A by L. Throws NotPositiveDefinite; @p what is the name of A.
    void
    factorize(const std::string &what);
    /// Returns the squared ratio of the smallest to the largest pivot of L.
    double
    reciprocal_condition() const
    {
      return reciprocal;
    }

    /// Computes x = L^-1 x for @p count vectors at @p x in elimination order.
    void
    forward(double *const x, const dealii::types::blas_int count) const;
    /// Computes x = L^-T x; the arguments are those of forward().
    void
    backward(double *const x, const dealii::types::blas_int count) const;

    /// Returns a view of L, which does not own its data.
    SupernodalFactor
    view() const;

  private:
    double *
    entries(const unsigned int s)
    {
      return entry.data() + pattern.first_entry[s];
    }
    const double *
    entries(const unsigned int s) const
    {
      return entry.data() + pattern.first_entry[s];
    }
    /// Returns the smallest and the largest pivot of block column @p s. Throws
    /// NotPositiveDefinite if a pivot is not positive.
    std::pair<double, double>
    pivots(const unsigned int s, const std::string &what) const;
    /// Subtracts the contribution of block column @p s of L from later columns.
    void
    update(const unsigned int s);
    [[noreturn]] void
    throw_not_definite(const unsigned int            s,
                       const dealii::types::blas_int pivot,
                       const std::string            &what) const;

    BlockPattern        pattern;
    std::vector<double> entry;
    double              reciprocal = 0.;
  };
} // namespace lamella

#endif
