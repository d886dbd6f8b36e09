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
    PointCompliance compliance;
    /// Gap and slip of each point under the forces `about` (empty: zero).
    PointVectors q, about = {};
    /// Friction coefficient mu of each point.
    std::vector<double> friction;
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
    PointVectors            force;
    std::vector<PointState> states;
    /// Relative error: largest component of lambda - P(lambda - v), with the
    /// projection P onto the friction cone |lambda_t| <= mu lambda_n, over the
    /// largest scaled force if that exceeds 1.
    double error = 0.;
    /// Sign of the determinant of the matrix that maps the contact forces to
    /// the gaps and sticking slips of closed points: -1 for an unstable
    /// solution; 1 if no point is closed. W is regularized in case there are
    /// more contact points than surface DoFs.
    int stability = 1;
    /// Name of the method that ended the first round, for reports, and total
    /// number of linear systems solved.
    std::string  by;
    unsigned int iterations = 0;
  };

  /// Tolerances and limits of solve_coulomb() and its methods 1 to 3.
  struct CoulombRules
  {
    /// Tolerance of CoulombSolution::error.
    double tolerance = 1e-11;
    /// Regularization of W relative to the largest diagonal entry of a point,
    /// which makes W definite; proximal iterations remove its effect.
    double compliance = 1e-10;
    /// Regularization of W for the stability test, relative to the diagonal.
    double stability_regularization = 1e-4;
    /// Proximal iterations end after `max_rounds`, after `idle` rounds without
    /// a smaller error, or if the error of a round exceeds `failed`.
    unsigned int max_rounds = 30, idle = 2;
    double       failed = 1e-6;
    /// Maximum number of Newton iterations from the initial forces, after
    /// Gauss-Seidel sweeps, and after method 2.
    unsigned int first_iterations = 3, iterations = 40, last_iterations = 12;
    /// Maximum number of Newton iterations after the tolerance is met. They go
    /// on while each reduces the error tenfold and it exceeds `digits`.
    unsigned int extra_iterations = 3;
    double       digits           = 1e-15;
    /// Number of the first Newton iteration with a line search; numbers of
    /// Gauss-Seidel sweeps and of rounds of method 2.
    unsigned int damped_from = 4;
    unsigned int sweeps      = 20;
    unsigned int cone_rounds = 6;
    /// Method 2 uses at least this friction coefficient in cone_minimum().
    double min_friction = 1e-4;
    /// Method 3: initial regularizations relative to the diagonal of W in its
    /// two attempts, and their factors of decrease. If the error exceeds
    /// `solved`, the regularization is multiplied by `increase_factor`. Limits:
    /// rounds, and Gauss-Seidel sweeps per round.
    double first_compliance = 0.1, second_compliance = 1.;
    double decrease_factor = 0.1, slow_decrease_factor = 0.3,
           increase_factor = 5., solved = 1e-9;
    unsigned int max_regularized_rounds = 60, regularized_sweeps = 200;
  };

  /**
   * Solves @p problem, starting from the forces @p start, such as those of the
   * previous load step. The first of the following methods that converges
   * gives the result:
   *   1 Newton's method on lambda = P(lambda - v), P the projection onto the
   *     friction cone (Alart and Curnier, Comput. Methods Appl. Mech. Eng. 92
   *     (1991) 353-375), from @p start, then after Gauss-Seidel sweeps;
   *   2 Newton's method from the result of cone_minimum(), with gaps opened by
   *     mu |v_t| of the previous round (de Saxce and Feng, Math. Comput. Model.
   *     28 (1998) 225-245; Acary, Cadoux, Lemarechal and Malick, Z. Angew.
   *     Math. Mech. 91 (2011) 155-175);
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
