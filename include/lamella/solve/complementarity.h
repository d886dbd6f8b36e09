// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_complementarity_h
#define lamella_solve_complementarity_h

#include <vector>

namespace lamella
{
  /// The linear complementarity problem
  ///   s = M lambda + q >= 0,  lambda >= 0,  s_i lambda_i = 0
  /// with a dense symmetric positive definite M. Its unique solution minimizes
  /// 1/2 lambda^T M lambda + q^T lambda over lambda >= 0. In contact, M is the
  /// regularized compliance of the contact constraints, q their gaps without
  /// contact forces, and s those under the forces lambda (Eq. 18).
  struct ComplementarityProblem
  {
    /// Entries of M by columns [length/force if s is a gap]; positive diagonal.
    std::vector<double> matrix;
    /// The n entries of q: s at lambda = 0.
    std::vector<double> q;
    /// Tolerance in the unit of q; any s_i above -tolerance counts as zero.
    double tolerance = 0.;
  };

  /// Solution of a ComplementarityProblem, with numbers of iterations.
  struct ComplementaritySolution
  {
    /// The n entries of lambda, none negative.
    std::vector<double> lambda;
    /// True where lambda_i > 0.
    std::vector<bool> active;
    /// Numbers of active sets tried, and of interior-point iterations.
    unsigned int pivot_rounds = 0, interior_iterations = 0;
  };

  /// Solves @p problem, starting from the active set @p start (one entry per
  /// constraint). An active set A gives lambda_A = -M_AA^-1 q_A, zero
  /// elsewhere, and s = M lambda + q. It is correct if no entry is negative.
  ///
  /// First, block principal pivoting is used: constraints with lambda_i < 0 are
  /// deactivated, those with s_i < 0 activated (Kostreva, 1978; the primal-dual
  /// active set method). If it does not converge in ten rounds, an
  /// interior-point method (Mehrotra, 1992) finds a better start. If the number
  /// of wrong constraints then does not fall for three rounds, only the one
  /// with the largest index changes (Murty's rule; Judice and Pires, 1994).
  /// After 10 n + 100 sets, the last is returned.
  ///
  /// Costs in operations: |A|^3 / 3 for the Cholesky factor of a set and n |A|
  /// for s; n^3 / 3 for an interior-point iteration. Throws NumericsError if a
  /// factorized block of M is not positive definite. Not collective.
  ComplementaritySolution
  solve_complementarity(const ComplementarityProblem &problem,
                        const std::vector<bool>      &start);
} // namespace lamella

#endif
