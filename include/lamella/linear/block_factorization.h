// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_block_factorization_h
#define lamella_linear_block_factorization_h

#include <lamella/linear/stiffness_matrix.h>

namespace lamella
{
  /// Dense blocks of a matrix, as for a beam whose nodes have lists of dense
  /// fields: one block per pair of nodes of an element.
  struct DenseBlocks
  {
    /// Block g has the DoFs first[g] to first[g + 1] - 1; as many entries as
    /// blocks, and n_dofs at the end.
    std::vector<DofIndex> first;
    /// Sets of blocks that all couple with each other: the nodes of an element.
    std::vector<std::vector<unsigned int>> cliques;
  };

  /**
   * Factorizes the stiffness of @p terms, condensed by @p constraints
   * (StiffnessMatrix), block by block: A = P^T L L^T P, where P permutes blocks
   * and keeps the order of the DoFs within each.
   *
   * There is no sparse matrix: terms are assembled into L (its lower triangle
   * by supernodes, one per block; SupernodalFactor) and factorized there by
   * LAPACK's potrf and the BLAS's trsm, syrk and gemm. Memory is 8 bytes per
   * nonzero of L; a sparse matrix with its copy and ordering takes several
   * times as much. Springs and constraints may couple any blocks.
   *
   * Blocks of one clique (inner nodes of an element) are eliminated first, the
   * others by nested dissection along their numbers, the first and the last at
   * the end (springs may connect both ends of a body). A chain then has a fill
   * of a few blocks per node, and a half-solved row passes through a number of
   * blocks logarithmic in theirs.
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
