// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_block_factorization_h
#define lamella_linear_block_factorization_h

#include <lamella/linear/stiffness_matrix.h>

namespace lamella
{
  /// Partition of the DoFs of a matrix into dense blocks, e.g. one block per
  /// node of the axis of a beam, and the coupling of the blocks.
  struct DenseBlocks
  {
    /// First DoF of each block, and at the end the number of DoFs. Block g has
    /// the DoFs first[g] to first[g + 1] - 1.
    std::vector<DofIndex> first;
    /// Sets of mutually coupled blocks, such as the nodes of an element.
    std::vector<std::vector<unsigned int>> cliques;
  };

  /// Factorizes the stiffness matrix A of @p terms, condensed by @p
  /// constraints, by dense blocks: A = P^T L L^T P, where P permutes blocks.
  ///
  /// A is assembled into the storage of L (see SupernodalFactor, one supernode
  /// per block) and factorized in place by LAPACK and BLAS. L takes 8 bytes per
  /// nonzero.
  ///
  /// Elimination order: first the blocks that belong to only one clique (inner
  /// nodes of an element), then the other blocks by nested dissection along
  /// their indices, at last the first and the last block. For a chain of n
  /// elements, the fill-in is a few blocks per node, and a row of
  /// ForwardSolvedRows has O(log n) blocks.
  ///
  /// @p monitor is called with the size of L before memory is allocated, and at
  /// the end of the assembly. The condition estimate is the squared ratio of
  /// the largest to the smallest pivot. Throws NotPositiveDefinite, with @p
  /// what as name of A, if a pivot is not positive, NumericsError if memory is
  /// insufficient. Serial.
  std::unique_ptr<LinearSolver>
  factorize_blocks(const StiffnessTerms &terms,
                   const DenseBlocks    &blocks,
                   const Constraints    &constraints,
                   const std::string    &what,
                   const SolverMonitor  &monitor = {});
} // namespace lamella

#endif
