// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_block_pattern_h
#define lamella_linear_block_pattern_h

#include <lamella/linear/block_factorization.h>

#include <deal.II/lac/lapack_support.h>

#include <cstdint>
#include <vector>

namespace lamella
{
  /// Sparsity of the factor L of a matrix of dense blocks with the elimination
  /// order: the symbolic part of factorize_blocks(). Each block is a supernode
  /// of L. Blocks are numbered in the order of elimination.
  struct BlockPattern
  {
    /// A block below the diagonal: its number, and its first row in the column.
    struct Part
    {
      unsigned int            block;
      dealii::types::blas_int row;
    };

    /// Analyzes the matrix of @p terms, coupled by constraints and springs,
    /// too.
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
    /// Returns the number of columns of L of block @p s, and of their rows.
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
    /// Blocks below each block, ascending.
    std::vector<std::vector<Part>> parts;
    /// Arrays of SupernodalFactor.
    std::vector<std::int64_t> column, first_row, first_entry, row, permutation;

  private:
    /// Returns the groups of coupled blocks by their numbers in @p blocks.
    std::vector<std::vector<unsigned int>>
    cliques_of(const StiffnessTerms &terms,
               const DenseBlocks    &blocks,
               const Constraints    &constraints) const;
    /// Assigns columns of L to the blocks in the elimination @p order.
    void
    number_columns(const DenseBlocks               &blocks,
                   const std::vector<unsigned int> &order);
    /// Adds the next column of L, with the blocks @p below its diagonal.
    template <typename Blocks>
    void
    add_column(const Blocks &below);
    void
    add_rows_of(const unsigned int block);
  };
} // namespace lamella

#endif
