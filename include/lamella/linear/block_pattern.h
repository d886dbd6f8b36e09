// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_block_pattern_h
#define lamella_linear_block_pattern_h

#include <lamella/linear/block_factorisation.h>

#include <deal.II/lac/lapack_support.h>

#include <cstdint>
#include <vector>

namespace lamella
{
  /**
   * Where the factor L of a matrix of dense blocks has entries: the symbolic
   * part of factorise_blocks(), which says in which order blocks are
   * eliminated. Each block is a supernode of L, its column the blocks that it
   * couples with when it is eliminated; the arrays are those of
   * SupernodalFactor. Blocks are named by their place in the order of
   * elimination.
   */
  struct BlockPattern
  {
    /// A block below the diagonal of a column of L: its place in the order,
    /// and its first row in the column.
    struct Part
    {
      unsigned int            block;
      dealii::types::blas_int row;
    };

    /// Of the matrix that the terms make, condensed; constraints and springs
    /// couple blocks, too.
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
    /// The columns of L that block @p s has, and their rows.
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

    /// Of each DoF its block and of each block its first DoF.
    std::vector<unsigned int> block_of;
    std::vector<DofIndex>     first_dof;
    /// Of each block those below it, ascending.
    std::vector<std::vector<Part>> parts;
    /// See SupernodalFactor.
    std::vector<std::int64_t> column, first_row, first_entry, row, permutation;

  private:
    /// Groups of blocks that couple, by the numbers that they have in
    /// @p blocks, as block_of must have them, too.
    std::vector<std::vector<unsigned int>>
    cliques_of(const StiffnessTerms &terms,
               const DenseBlocks    &blocks,
               const Constraints    &constraints) const;
    /// Gives columns of L to the blocks in the @p order of their elimination.
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
