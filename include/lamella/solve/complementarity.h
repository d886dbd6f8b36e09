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
  /// contact forces, and s their gaps under the forces lambda.
  struct ComplementarityProblem
  {
    /// Entries of M by columns [length/force if s is a gap]; positive diagonal.
    std::vector<double> matrix;
    /// The n values of s for lambda = 0, e.g. gaps without contact forces.
    std::vector<double> q;
    /// Tolerance in the unit of q; values of s above -tolerance count as zero.
    double tolerance = 0.;
  };

  /// Solution of a ComplementarityProblem, with numbers of iterations.
  struct ComplementaritySolution
  {
    /// The n unknowns lambda, e.g. contact forces; none is negative.
    std::vector<double> lambda;
    std::vector<bool>   active; ///< Flags of the constraints with lambda_i > 0.
    unsigned int        pivot_rounds = 0, ///< Number of active sets tried.
      interior_iterations = 0; ///< Number of interior-point iterations.
  };

  /// Solves @p problem, starting from the flags @p start of active constraints.
  /// An active set A gives lambda_A = -M_AA^-1 q_A, zero elsewhere, and s = M
  /// lambda + q. It is correct if lambda and s have no negative entries.
  ///
  /// First, block principal pivoting is used: constraints with lambda_i < 0 are
  /// deactivated, those with s_i < 0 activated (Kostreva, 1978; the primal-dual
  /// active set method). If ten rounds do not converge, the interior point
  /// method (solve_by_interior_point()) finds a better one. If the number of
  /// wrong constraints still does not fall for three rounds, only the wrong
  /// constraint with the largest index changes (Murty's rule; Judice and Pires,
  /// 1994). After 10 n + 100 sets, the solution for the last one is returned.
  ///
  /// Costs in operations: |A|^3 / 3 for the Cholesky factor of a set and n |A|
  /// for s; n^3 / 3 for an interior-point iteration. Throws NumericsError if a
  /// factorized block of M is not positive definite. Not collective.
  ComplementaritySolution
  solve_complementarity(const ComplementarityProblem &problem,
                        const std::vector<bool>      &start);
} // namespace lamella

#endif
