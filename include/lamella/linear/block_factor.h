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
  /// The factor L of A = P^T L L^T P with the sparsity of a BlockPattern: the
  /// numeric part of factorize_blocks(). A is assembled into L on and below the
  /// diagonal and factorized in place: each completed block updates the later
  /// ones.
  class BlockFactor
  {
  public:
    /// Stores the pattern without allocating entries.
    explicit BlockFactor(BlockPattern pattern);

    const BlockPattern &
    where() const
    {
      return pattern;
    }

    /// Allocates the entries of A, zero. Throws std::bad_alloc.
    void
    allocate();
    /// Returns the address of the entries of column DoF @p column of A in the
    /// rows of block @p block, as if that began with DoF 0; nullptr above the
    /// diagonal. The two must couple.
    double *
    column_begin(const DofIndex column, const unsigned int block);
    double &
    diagonal(const DofIndex dof);

    /// Replaces A by L. Throws NotPositiveDefinite; @p what names A in it.
    void
    factorize(const std::string &what);
    /// Returns the squared ratio of the smallest to the largest pivot.
    double
    reciprocal_condition() const
    {
      return reciprocal;
    }

    /// Computes x = L^-1 x or x = L^-T x for the @p count columns from @p x on,
    /// in the order of L.
    void
    forward(double *const x, const dealii::types::blas_int count) const;
    void
    backward(double *const x, const dealii::types::blas_int count) const;

    /// Returns a view that refers to this object.
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
    /// Returns the smallest and the largest pivot of the completed column @p s.
    /// Throws as factorize() does.
    std::pair<double, double>
    pivots(const unsigned int s, const std::string &what) const;
    /// Subtracts the contribution of column @p s of L from the later columns.
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
