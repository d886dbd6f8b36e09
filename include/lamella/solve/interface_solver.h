// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_interface_solver_h
#define lamella_solve_interface_solver_h

#include <lamella/base/arithmetic.h>
#include <lamella/solve/contact_problem.h>
#include <lamella/solve/interface_system.h>

#include <limits>
#include <vector>

namespace lamella
{
  /// Tolerances and limits of solve_interface().
  struct InterfaceRules
  {
    double tolerance = 1e-11; ///< Tolerance of InterfaceSolution::error.
    double digits    = 1e-15; ///< Error at which Newton's method ends.
    /// Maximum number of Newton iterations from the initial forces.
    unsigned int first_iterations = 12;
    unsigned int iterations       = 40; ///< Maximum after the interior point.
    /// Maximum number of Newton iterations after the tolerance is met. They
    /// continue while each reduces the error tenfold.
    unsigned int extra_iterations = 3;
    unsigned int damped_from = 4; ///< First Newton iteration with line search.
    /// Initial compliance of the continuation, relative to that of a point.
    double first_compliance = 1.;
    double decrease_factor  = 0.3, ///< Factor of the compliance per round.
      increase_factor       = 5.,  ///< Its value if the error exceeds `solved`.
      solved                = 1e-9; ///< Error below which a round succeeds.
    unsigned int max_regularized_rounds = 60; ///< Maximum number of rounds.
  };

  /// Contact forces of an InterfaceSystem, with their error.
  struct InterfaceSolution
  {
    PointVectors            force;  ///< Contact forces (n, t_1, t_2).
    std::vector<PointState> states; ///< Contact state of each point.
    /// Relative error of the law, the largest component of lambda - P(lambda -
    /// D v) over that of lambda or D v, with forces lambda, lengths v
    /// and stiffness D of the points. Components are scaled by 1 / sqrt D.
    double error = std::numeric_limits<double>::max();
    /// Sign of the determinant of the matrix that maps contact forces to the
    /// gaps and sticking slips of closed points: -1 for an unstable solution,
    /// which no load path reaches; 1 if no point is closed.
    int             stability  = 1;
    InterfaceMethod by         = InterfaceMethod::newton; ///< Costliest.
    unsigned int    iterations = 0; ///< Number of linear systems solved.

    /// Replaces this solution by @p found if that has a smaller error, and adds
    /// up the iterations.
    void
    offer(const InterfaceSolution &found)
    {
      const unsigned int sum = iterations + found.iterations;
      if (found.error < error)
        *this = found;
      iterations = sum;
    }
  };

  /// Returns @p points with a compliance in addition, the fraction @p share of
  /// the inverse stiffness of each point, which acts on the change of the
  /// forces @p force.
  InterfacePoints
  softened(InterfacePoints     points,
           const double        share,
           const PointVectors &force);

  /// Error of the laws at contact forces with their gaps and slips.
  struct LawError
  {
    std::vector<PointState> states;       ///< State of each point.
    std::vector<double>     of_point;     ///< InterfaceSolution::error of each.
    double                  largest = 0.; ///< Largest of `of_point`.
  };

  /// Returns the error of the contact forces @p force with the gaps and slips
  /// @p v.
  LawError
  law_error(const InterfacePoints &points,
            const PointVectors    &force,
            const PointVectors    &v);

  /// Throws NumericsError if @p found violates the laws, with friction or
  /// without, by more than 1e-6.
  void
  check_law(const InterfaceSolution &found, const bool has_friction);

  /**
   * Solves the laws of all @p points with the equilibrium of @p system. The
   * first of the following methods that converges gives the result:
   *   1 Newton's method on lambda = P(lambda - D v), P the projection of the
   *     law, from the forces @p start;
   *   2 Newton's method from the result of solve_by_interior_point();
   *   3 proximal points (Rockafellar, SIAM J. Control Optim. 14 (1976) 877-898)
   *     with a decreasing compliance added to the points.
   * If none converges, the best solution is returned with its error. The
   * iterate of @p system belongs to the last iteration. @p monitor is called
   * after each iteration.
   */
  InterfaceSolution
  solve_interface(InterfaceSystem       &system,
                  const InterfacePoints &points,
                  const PointVectors    &start,
                  const Monitor         &monitor,
                  const InterfaceRules  &rules = {});

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
    PointVectors q, about = {}; ///< Reference forces; zero if empty.
    /// Law of each point, with which a coefficient of friction.
    std::vector<std::shared_ptr<const InterfaceLaw>> law;
  };

  /// Tolerances and limits of solve_coulomb().
  struct CoulombRules
  {
    /// Compliance of each point (softened()), so that the problem is definite
    /// and its sets of points do not change by rounding; proximal iterations
    /// remove its effect.
    double compliance       = 1e-8;
    double least_compliance = 1e-10; ///< Smallest compliance.
    /// Factor of the compliance after a proximal iteration that leaves more
    /// than this fraction of the error.
    double slow = 0.1;
    /// Compliance of each point for the stability test, in the same unit.
    double       stability_compliance = 1e-4;
    unsigned int max_rounds = 30; ///< Maximum number of proximal iterations.
    /// Proximal iterations end after this number without a smaller error.
    unsigned int idle = 2;
    /// Proximal iterations end if the error of one of them exceeds this value.
    double         failed = 1e-6;
    InterfaceRules interface; ///< Rules of each proximal iteration.
  };

  /// Solves @p problem by proximal iterations of solve_interface(), starting
  /// from the forces @p start, such as those of the previous load step. If it
  /// does not converge, the best solution is returned with its error.
  InterfaceSolution
  solve_coulomb(const CoulombProblem &problem,
                const PointVectors   &start,
                const CoulombRules   &rules = {});

  /// Tolerances of solve_by_interior_point(). Lengths are relative to the
  /// largest gap, and forces to the largest force of the starting point.
  struct InteriorPointParameters
  {
    /// The iteration ends if the mean product of gap and normal force falls
    /// below this fraction of the scales, or after `max_iterations`.
    /// Points with little force at little gap then have 1e-9 of both.
    double tolerance = 100. * arithmetic::rounding_of_solutions *
                       arithmetic::rounding_of_solutions;
    unsigned int max_iterations = 60;  ///< Maximum number of steps.
    double       first_gap      = 0.1; ///< Initial gap of each point.
    double       first_force    = 0.1; ///< Initial normal force of each point.
    /// Fraction of the step to the boundary of the feasible set.
    double to_boundary = 0.9995;
    /// A point whose force over gap falls below this ratio has no shear force.
    double opening = 1e-2;
  };

  /**
   * Solves contact with Coulomb friction approximately, by a primal-dual
   * interior point method that starts from no information: it finds the open,
   * sticking and slipping points in a number of factorizations that hardly
   * grows with the number of points. The last digits are left to Newton's
   * method. Returns the contact force of each point, zero where it is open;
   * the iterate of @p system has the gaps and slips. @p monitor is called
   * after each step. Throws NumericsError if a matrix cannot be factorized.
   *
   * With the lengths (v_n, v_t) of a point, the compliance of the law included,
   * and the bound b = mu lambda_n of the last iterate, which is constant in
   * each Newton step, the equations are
   *   v_n = s,                  s lambda_n = sigma,
   *   v_t + gamma lambda_t = 0, gamma (b^2 - |lambda_t|^2) = sigma b,
   * with s, lambda_n, gamma > 0 and |lambda_t| < b. The parameter sigma
   * decreases to zero by Mehrotra's rule (SIAM J. Optim. 2 (1992) 575-601).
   */
  PointVectors
  solve_by_interior_point(InterfaceSystem               &system,
                          const InterfacePoints         &points,
                          const Monitor                 &monitor,
                          const InteriorPointParameters &parameters = {});
} // namespace lamella

#endif
