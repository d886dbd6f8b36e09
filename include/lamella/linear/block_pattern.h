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
  /// dense blocks; the symbolic part of factorize_blocks(). Each block is a
  /// supernode of L. Blocks are numbered in the order of elimination.
  struct BlockPattern
  {
    /// A block of L below the diagonal: number of the block row, and its first
    /// row within the storage of the block column.
    struct Part
    {
      unsigned int            block;
      dealii::types::blas_int row;
    };

    /// Computes the elimination order and the pattern of L for the stiffness
    /// matrix of @p terms. Constraints and springs couple further blocks.
    BlockPattern(const StiffnessTerms &terms,
                 const DenseBlocks    &blocks,
                 const Constraints    &constraints);

    unsigned int
    n_blocks() const
    {
      return parts.size();
    }
    std::int64_t
    n_entries() const
    {
      return first_entry.back();
    }
    /// Return the number of columns of L in block @p s and the number of rows
    /// stored for each of these columns.
    dealii::types::blas_int
    width(const unsigned int s) const
    {
      return column[s + 1] - column[s];
    }
    dealii::types::blas_int
    height(const unsigned int s) const
    {
      return first_row[s + 1] - first_row[s];
    }

    /// Block of each DoF, and first DoF of each block.
    std::vector<unsigned int> block_of;
    std::vector<DofIndex>     first_dof;
    /// Nonzero blocks below the diagonal in each block column, ascending.
    std::vector<std::vector<Part>> parts;
    /// The members of SupernodalFactor with these names point to these arrays.
    std::vector<std::int64_t> column, first_row, first_entry, row, permutation;

  private:
    /// Returns the sets of blocks coupled by elements, springs or constraints,
    /// with the block numbers of @p blocks.
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
