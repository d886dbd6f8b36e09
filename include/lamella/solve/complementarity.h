// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_complementarity_h
#define lamella_solve_complementarity_h

#include <vector>

namespace lamella
{
  /**
   * The linear complementarity problem
   *   s = M lambda + q >= 0,  lambda >= 0,  s_i lambda_i = 0
   * with a dense symmetric positive definite M: the minimum over lambda >= 0 of
   *   1/2 lambda^T M lambda + q^T lambda,
   * which has one solution. With M the compliance of contact rows, softened,
   * and q their free gaps, s are the gaps under the contact forces lambda, and
   * the conditions are those of Eq. 18 with lambda positive in compression.
   */
  struct ComplementarityProblem
  {
    /// The n x n entries of M, column by column; both triangles are read. The
    /// diagonal must be positive. A length over a force, if s is a gap.
    std::vector<double> matrix;
    /// The n entries of q: s without any lambda.
    std::vector<double> q;
    /// An s that is less negative than this counts as zero, whatever rounding
    /// adds to that; in the unit of q.
    double tolerance = 0.;
  };

  /// The answer, and how it was found.
  struct ComplementaritySolution
  {
    /// The n entries of lambda, none negative.
    std::vector<double> lambda;
    /// Whether lambda_i > 0.
    std::vector<bool> active;
    /// How it was found: solved sets, and iterations of the interior point.
    /// Both zero: no q was below zero, and lambda = 0 is the answer.
    unsigned int pivot_rounds = 0, interior_iterations = 0;
  };

  /**
   * Solves @p problem, beginning with the active set @p start (an entry for
   * each row). A set A makes lambda_A = -M_AA^-1 q_A, zero elsewhere, and
   * s = M lambda + q; it is right if no lambda in it and no s outside of it is
   * negative.
   *
   * Block principal pivoting is tried first: all rows with lambda_i < 0 open,
   * all with s_i < 0 close (Kostreva, 1978; the primal-dual active set method).
   * Where that does not settle in ten rounds, an interior point method finds
   * the set, in 10 to 25 iterations whatever the size (Mehrotra, 1992), and
   * pivoting ends it; should the number of wrong rows then not fall for three
   * rounds, only the one with the largest number changes (Murty's rule), which
   * cannot cycle for a positive definite M (Judice and Pires, 1994).
   *
   * M and q are scaled first, so units do not matter. A lambda_i that is zero,
   * or negative by rounding, opens its row, which costs an s_i of the size of
   * rounding: rows that just touch do no harm.
   *
   * A solved set costs |A|^3 / 3 for its Cholesky factor and n |A| for s, an
   * iteration of the interior point n^3 / 3; memory is n^2 twice or three
   * times. Murty's rule has no such bound: it is given up after 10 n + 100
   * sets, and what stands there is returned.
   *
   * Throws NumericsError if M is not positive definite, so far as its blocks
   * are factorised. All processes may do the same work; nothing is shared.
   */
  ComplementaritySolution
  solve_complementarity(const ComplementarityProblem &problem,
                        const std::vector<bool>      &start);
} // namespace lamella

#endif
