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
   * 1/2 lambda^T M lambda + q^T lambda. With M the compliance of contact rows
   * and q their free gaps, s are the gaps under the contact forces lambda.
   */
  struct ComplementarityProblem
  {
    /// The n x n entries of M, column by column; both triangles are read.
    std::vector<double> matrix;
    std::vector<double> q;
    /// An s that is less negative than this counts as zero, whatever rounding
    /// adds to that.
    double tolerance = 0.;
  };

  struct ComplementaritySolution
  {
    std::vector<double> lambda;
    /// Whether lambda_i > 0.
    std::vector<bool> active;
    /// How it was found: solved sets, and iterations of the interior point.
    unsigned int pivot_rounds = 0, interior_iterations = 0;
  };

  /**
   * Solves @p problem, beginning with the active set @p start. Block principal
   * pivoting is tried first: all rows with lambda_i < 0 open, all with s_i < 0
   * close (Kostreva, 1978; the primal-dual active set method). Where that does
   * not settle in a few rounds, an interior point method finds the set, in 10
   * to 25 iterations whatever the size (Mehrotra, 1992), and pivoting ends it;
   * should the number of wrong rows then not fall, only the one with the
   * largest number changes (Murty's rule), which cannot cycle for a positive
   * definite M (Judice and Pires, 1994).
   *
   * M and q are scaled first, so units do not matter. A lambda_i that is zero,
   * or negative by rounding, opens its row, which costs an s_i of the size of
   * rounding: rows that just touch do no harm.
   *
   * Throws NumericsError if M is not positive definite.
   */
  ComplementaritySolution
  solve_complementarity(const ComplementarityProblem &problem,
                        const std::vector<bool>      &start);
} // namespace lamella

#endif
