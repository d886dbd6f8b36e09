// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_block_factorization_h
#define lamella_linear_block_factorization_h

#include <lamella/linear/stiffness_matrix.h>

namespace lamella
{
  /// Dense blocks of a matrix, one per pair of nodes of an element.
  struct DenseBlocks
  {
    /// Block g has the DoFs first[g] to first[g + 1] - 1; as many entries as
    /// blocks, and n_dofs at the end.
    std::vector<DofIndex> first;
    /// Sets of blocks that all couple with each other: the nodes of an element.
    std::vector<std::vector<unsigned int>> cliques;
  };

  /**
   * Factorizes the stiffness of @p terms, condensed by @p constraints, block by
   * block: A = P^T L L^T P, where P permutes blocks.
   *
   * Terms are assembled into L (its lower triangle by supernodes, one per
   * block; SupernodalFactor) without a sparse matrix. They are factorized there
   * by LAPACK's potrf and the BLAS's trsm, syrk and gemm. Memory is 8 bytes per
   * nonzero of L. Springs and constraints may couple any blocks.
   *
   * Blocks of one clique (inner nodes of an element) are eliminated first, the
   * others by nested dissection along their numbers. The first and the last
   * block are eliminated at the end. A chain then has a fill of a few blocks
   * per node; the length of a half-solved row is logarithmic in their number.
   *
   * @p monitor receives the size before memory is allocated, then the end of
   * the assembly. Throws NotPositiveDefinite as factorize() does, with the same
   * condition estimate, and NumericsError without enough memory. Serial.
   */
  std::unique_ptr<LinearSolver>
  factorize_blocks(const StiffnessTerms &terms,
                   const DenseBlocks    &blocks,
                   const Constraints    &constraints,
                   const std::string    &what,
                   const SolverMonitor  &monitor = {});
} // namespace lamella

#endif
