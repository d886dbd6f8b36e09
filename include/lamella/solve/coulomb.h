// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_coulomb_h
#define lamella_solve_coulomb_h

#include <lamella/solve/point_compliance.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Unilateral contact with Coulomb friction, reduced to the contact points by
  /// their dense compliance W. The gap v_n and the slip increment v_t of each
  /// point depend on the contact forces lambda as
  ///   v = q + W (lambda - lambda_0),
  /// with v = q at the forces lambda_0 = `about`. The forces satisfy
  ///   v_n >= 0,   lambda_n >= 0,   v_n lambda_n = 0,
  ///   |lambda_t| <= mu lambda_n,
  ///   v_t = 0 where |lambda_t| < mu lambda_n,
  ///   lambda_t = -mu lambda_n v_t / |v_t| where v_t is not zero.
  /// W may be singular. The solution is unique for small mu only.
  struct CoulombProblem
  {
    PointCompliance compliance; ///< Compliance W of the contact points.
    /// Gap and slip of each point under the forces `about`.
    PointVectors        q, about = {}; ///< Reference forces; zero if empty.
    std::vector<double> friction; ///< Friction coefficient mu of each point.
  };

  /// Contact state of a point.
  enum class PointState
  {
    open,
    stick,
    slip
  };

  /// Solution of a CoulombProblem, with its error and numbers of iterations.
  struct CoulombSolution
  {
    PointVectors            force;  ///< Contact forces (n, t_1, t_2).
    std::vector<PointState> states; ///< Contact state of each point.
    /// Relative error of the contact law: the largest component of lambda -
    /// P(lambda - v), with forces lambda, gaps and slips v and the projection P
    /// onto the friction cone, over the largest force if above 1. Forces are
    /// scaled.
    double error = 0.;
    /// Sign of the determinant of the matrix that maps contact forces to the
    /// gaps and sticking slips of closed points: -1 for an unstable solution,
    /// which no load path reaches; 1 if no point is closed.
    int          stability = 1;
    std::string  by; ///< Method that ended the first proximal iteration.
    unsigned int iterations = 0; ///< Total number of linear systems solved.
  };

  /// Tolerances and limits of the three methods listed in solve_coulomb().
  struct CoulombRules
  {
    double tolerance = 1e-11; ///< Tolerance of CoulombSolution::error.
    /// Regularization added to W, relative to the largest diagonal entry of a
    /// point, so that W is definite; proximal iterations remove its effect.
    double compliance = 1e-10;
    /// Regularization of W for the stability test, relative to its diagonal.
    double       stability_regularization = 1e-4;
    unsigned int max_rounds = 30; ///< Maximum number of proximal iterations.
    /// Proximal iterations end after this number without a smaller error.
    unsigned int idle = 2;
    /// Proximal iterations end if the error of one of them exceeds this value.
    double failed = 1e-6;
    /// Maximum number of Newton iterations from the initial forces.
    unsigned int first_iterations = 3;
    unsigned int iterations       = 40; ///< Maximum after the interior point.
    /// Maximum number of Newton iterations after the tolerance is met. They
    /// continue while each reduces the error tenfold.
    unsigned int extra_iterations = 3;
    double       digits           = 1e-15; ///< Error at which Newton ends.
    unsigned int damped_from = 4; ///< First Newton iteration with line search.
    /// Initial regularization of W in method 3, relative to its diagonal.
    double first_compliance = 1.;
    double decrease_factor  = 0.3, ///< Factor of regularization per round.
      increase_factor       = 5.,  ///< Its value if the error exceeds `solved`.
      solved = 1e-9; ///< Error below which a round of method 3 succeeds.
    unsigned int max_regularized_rounds = 60; ///< Maximum rounds of method 3.
  };

  /**
   * Solves @p problem, starting from the forces @p start, such as those of the
   * previous load step. The first of the following methods that converges
   * gives the result:
   *   1 Newton's method on lambda = P(lambda - v), P the projection onto the
   *     friction cone (Alart and Curnier, Comput. Methods Appl. Mech. Eng. 92
   *     (1991) 353-375), from @p start;
   *   2 Newton's method from the result of solve_by_interior_point();
   *   3 proximal points (Rockafellar, SIAM J. Control Optim. 14 (1976) 877-898)
   *     with a decreasing regularization added to the diagonal of W.
   * If no method converges, the best solution is returned with its error.
   */
  CoulombSolution
  solve_coulomb(const CoulombProblem &problem,
                const PointVectors   &start,
                const CoulombRules   &rules = {});
} // namespace lamella

#endif
