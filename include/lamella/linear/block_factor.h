// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_block_factor_h
#define lamella_linear_block_factor_h

#include <lamella/linear/block_pattern.h>
#include <lamella/linear/half_solved_rows.h>

#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /**
   * The factor L of A = P^T L L^T P in the places of a BlockPattern: the
   * numeric part of factorise_blocks(). A is added into the places of L, those
   * on and below the diagonal, and factorised there, right-looking: a block
   * that is done takes what it does to later ones out of them.
   */
  class BlockFactor
  {
  public:
    /// Has no memory for entries yet.
    explicit BlockFactor(BlockPattern pattern);

    const BlockPattern &
    where() const
    {
      return pattern;
    }

    /// All entries of A, zero. Throws std::bad_alloc.
    void
    allocate();
    /// Where the entry of the DoF @p column of A in the rows of the block
    /// number @p block would begin if that began with DoF 0; nullptr where it
    /// is above the diagonal. The two must couple.
    double *
    begin_of(const DofIndex column, const unsigned int block);
    double &
    diagonal(const DofIndex dof);

    /// Replaces A by L. Throws NotPositiveDefinite, in which @p what names A.
    void
    factorise(const std::string &what);
    /// The square of the ratio of the least to the largest pivot, an estimate.
    double
    reciprocal_condition() const
    {
      return reciprocal;
    }

    /// x = L^-1 x and x = L^-T x of the @p count columns from @p x on, in the
    /// order of L.
    void
    forward(double *const x, const dealii::types::blas_int count) const;
    void
    backward(double *const x, const dealii::types::blas_int count) const;

    /// Refers to this.
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
    /// The least and the largest pivot of the column @p s, which is done.
    /// Throws as factorise() does.
    std::pair<double, double>
    pivots(const unsigned int s, const std::string &what) const;
    /// Takes what the column @p s of L does to later ones out of them.
    void
    update(const unsigned int s);
    [[noreturn]] void
    break_down(const unsigned int            s,
               const dealii::types::blas_int pivot,
               const std::string            &what) const;

    BlockPattern        pattern;
    std::vector<double> entry;
    double              reciprocal = 0.;
  };
} // namespace lamella

#endif
