// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_block_pattern_h
#define lamella_linear_block_pattern_h

#include <lamella/linear/block_factorization.h>

#include <deal.II/lac/lapack_support.h>

#include <cstdint>
#include <vector>

namespace lamella
{
  /// Sparsity and elimination order of the Cholesky factor L of a matrix of
  /// dense blocks (factorize_blocks()). Each block is a supernode of L. Blocks
  /// are numbered in the order of elimination.
  struct BlockPattern
  {
    /// A nonzero block of L below the diagonal, within a block column.
    struct Part
    {
      unsigned int            block; ///< Index of the block row.
      dealii::types::blas_int row;   ///< First row in the block column.
    };

    /// Computes the elimination order and the pattern of L for the stiffness
    /// matrix of @p terms, whose DoFs are grouped into @p blocks. @p
    /// constraints and springs couple further blocks.
    BlockPattern(const StiffnessTerms &terms,
                 const DenseBlocks    &blocks,
                 const Constraints    &constraints);

    /// Returns the number of blocks.
    unsigned int
    n_blocks() const
    {
      return parts.size();
    }
    /// Returns the number of stored entries of L.
    std::int64_t
    n_entries() const
    {
      return first_entry.back();
    }
    /// Returns the number of columns of L in block @p s.
    dealii::types::blas_int
    width(const unsigned int s) const
    {
      return column[s + 1] - column[s];
    }
    /// Returns the number of rows of L stored for each column of block @p s.
    dealii::types::blas_int
    height(const unsigned int s) const
    {
      return first_row[s + 1] - first_row[s];
    }

    std::vector<unsigned int> block_of;  ///< Block of each DoF.
    std::vector<DofIndex>     first_dof; ///< First DoF of each block.
    /// Nonzero blocks below the diagonal in each block column, ascending.
    std::vector<std::vector<Part>> parts;
    std::vector<std::int64_t>
      column,      ///< SupernodalFactor::column: first column of each block.
      first_row,   ///< SupernodalFactor::first_row, offsets in `row`.
      first_entry, ///< SupernodalFactor::first_entry, offsets of entries.
      row,         ///< SupernodalFactor::row, row indices of each block.
      permutation; ///< SupernodalFactor::permutation, DoF of each row of L.

  private:
    /// Returns sets of blocks that elements, springs or constraints couple, as
    /// indices of @p blocks.
    std::vector<std::vector<unsigned int>>
    cliques_of(const StiffnessTerms &terms,
               const DenseBlocks    &blocks,
               const Constraints    &constraints) const;
    /// Assigns columns of L to the blocks in the elimination @p order.
    void
    number_columns(const DenseBlocks               &blocks,
                   const std::vector<unsigned int> &order);
    /// Appends a block column of L with the nonzero blocks @p below.
    template <typename Blocks>
    void
    add_column(const Blocks &below);
    void
    add_rows_of(const unsigned int block);
  };
} // namespace lamella

#endif
