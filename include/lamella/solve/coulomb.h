// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_coulomb_h
#define lamella_solve_coulomb_h

#include <lamella/solve/point_compliance.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * Unilateral contact with Coulomb's law on a dense compliance, about forces
   * lambda_0 under which gaps and slips are known. With
   *   v = q + W (lambda - lambda_0),
   * of each point the gap v_n and the slip v_t in the step, the forces lambda
   * obey
   *   v_n >= 0,   lambda_n >= 0,   v_n lambda_n = 0,
   *   |lambda_t| <= mu lambda_n,
   *   v_t = 0 where |lambda_t| < mu lambda_n,
   *   lambda_t = -mu lambda_n v_t / |v_t| where v_t is not zero.
   * A point without tangents has no friction. W may be singular, of rows that
   * depend on each other. There is a solution for every mu if W is definite;
   * it is unique for small mu only.
   */
  struct CoulombProblem
  {
    PointCompliance compliance;
    /// Of each point under the forces `about` its gap and its slip, and these
    /// forces; none means zero.
    PointVectors q, about = {};
    /// mu, of each point.
    std::vector<double> friction;
  };

  /// What a point does.
  enum class PointState
  {
    open,
    stick,
    slip
  };

  /// The answer, and how it was found.
  struct CoulombSolution
  {
    PointVectors            force;
    std::vector<PointState> states;
    /// The largest component of lambda - P(lambda - v), P the projection on
    /// what lambda_n allows, in a problem that is scaled to a unit diagonal and
    /// a largest q of one, over the largest force if that is above one.
    double error = 0.;
    /// The sign of det(R W C), with the rows R of closed points that do not
    /// move and the columns C of their forces: 1 or -1, an answer that is
    /// unstable; 1 if no point is closed. Patterns that W hardly feels, of more
    /// points than a surface can follow, have no say: it is that of W with a
    /// softness.
    int stability = 1;
    /// The step of the chain that ended the first proximal point, and systems
    /// of equations solved in all.
    std::string  by;
    unsigned int iterations = 0;
  };

  /// When the search ends, and how far each of its steps goes.
  struct CoulombRules
  {
    /// Of CoulombSolution::error.
    double tolerance = 1e-11;
    /// Of the largest diagonal entry of a point: what is added to W so that
    /// it is definite, and iterated out.
    double softness = 1e-10;
    /// The same for the sign of an answer that is unstable without. (A section
    /// that hardly bends across has 3e-9, against 1e-6 of what rubs there.)
    double firm = 1e-4;
    /// Of that iteration; a step of it that is off by more than `failed` is
    /// the last, and so are two on end that better nothing, at rounding.
    unsigned int max_rounds = 30, idle = 2;
    double       failed = 1e-6;
    /// Of Newton's method from the forces of before, after sweeps, and after
    /// the cones.
    unsigned int first_iterations = 3, iterations = 40, last_iterations = 12;
    /// Iterations after the tolerance is met, as long as each leaves a tenth of
    /// the error: what is small beside the largest q is good to more digits.
    unsigned int polish = 3;
    double       digits = 1e-15;
    /// From which iteration on steps are shortened.
    unsigned int damped_from = 4;
    unsigned int sweeps      = 20;
    unsigned int cone_rounds = 6;
    /// The narrowest cone that there is.
    double least_friction = 1e-4;
    /// Of falling softness: the shares of the diagonal that it begins with,
    /// from the forces so far and from none; what it falls and rises by, how
    /// well it is solved, and its rounds.
    double       first_softness = 0.1, second_softness = 1.;
    double       falls = 0.1, falls_slowly = 0.3, rises = 5., solved = 1e-9;
    unsigned int max_softened = 60, soft_sweeps = 200;
  };

  /**
   * Solves @p problem, beginning with the forces @p start (those of the load
   * step before, say). A chain, of which the first that ends is taken:
   *
   *   1 Newton's method in total form on the natural map (Alart and Curnier,
   *     Comput. Methods Appl. Mech. Eng. 92 (1991) 353-375), from the forces
   *     given and then after sweeps of Gauss and Seidel, from these and from
   *     none; steps that go round in circles are shortened;
   *   2 the same from the minimum on the cones (cone_minimum()), with gaps that
   *     are opened by mu |v_t| of the round before (de Saxce and Feng, Math.
   *     Comput. Model. 28 (1998) 225-245; Acary, Cadoux, Lemarechal and
   *     Malick, Z. Angew. Math. Mech. 91 (2011) 155-175);
   *   3 proximal points (Rockafellar, SIAM J. Control Optim. 14 (1976) 877-898)
   *     with a softness that falls: W + D, q - D lambda.
   *
   * The scale of a point is one number for its normal and one for both
   * tangents, so that the cone stays round. A Newton iteration costs 2/3 n^3, n
   * the rows of closed points. The solution is returned with its error also
   * where nothing ended: who calls has to look at it.
   */
  CoulombSolution
  solve_coulomb(const CoulombProblem &problem,
                const PointVectors   &start,
                const CoulombRules   &rules = {});
} // namespace lamella

#endif
