// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_block_factorisation_h
#define lamella_linear_block_factorisation_h

#include <lamella/linear/stiffness_matrix.h>

namespace lamella
{
  /// Where a matrix has dense blocks: what a beam has whose nodes carry lists
  /// of dense fields, a block for each pair of nodes of an element.
  struct DenseBlocks
  {
    /// Block g has the DoFs first[g] to first[g + 1] - 1; as many entries as
    /// blocks and n_dofs at the end.
    std::vector<DofIndex> first;
    /// Sets of blocks that couple, each with each: the nodes of an element.
    std::vector<std::vector<unsigned int>> cliques;
  };

  /**
   * Factorises the stiffness of @p terms, condensed by @p constraints
   * (StiffnessMatrix), block by block: A = P^T L L^T P, where P numbers blocks
   * and leaves the DoFs in each as they are.
   *
   * There is no sparse matrix: the terms are added into the places of L (its
   * lower triangle by supernodes, a block each; SupernodalFactor) and
   * factorised there, by LAPACK's potrf and the BLAS's trsm, syrk and gemm
   * between whole blocks. So it takes 8 bytes for each non-zero of L and
   * nothing else, where a sparse matrix, its copy and its ordering take several
   * times as much. Springs and constraints may couple any blocks.
   *
   * Blocks of one clique (inner nodes of an element) are eliminated first, the
   * others by nested dissection along their numbers, the first and the last at
   * the end (springs may tie both ends of a body): of a chain the fill is some
   * blocks a node, and a half solved row passes through the logarithm of their
   * number.
   *
   * @p monitor is told the size before memory is spent, then that the matrix is
   * assembled. Throws NotPositiveDefinite as factorise() does, with the same
   * condition estimate, and NumericsError if there is no memory. Serial.
   */
  std::unique_ptr<LinearSolver>
  factorise_blocks(const StiffnessTerms &terms,
                   const DenseBlocks    &blocks,
                   const Constraints    &constraints,
                   const std::string    &what,
                   const SolverMonitor  &monitor = {});
} // namespace lamella

#endif
