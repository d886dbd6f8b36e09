// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/solve/coulomb.h>
#include <lamella/solve/dense_interface_system.h>

#include <algorithm>
#include <limits>

// Coulomb's law on a dense compliance W, which may be singular: proximal points
// about the last forces with a small compliance, which makes the problem
// definite (Rockafellar, SIAM J. Control Optim. 14 (1976) 877-898). They
// converge to a solution of the exact law. The error is that of the exact law.
// The sign of the determinant is evaluated once more with a larger compliance
// if it indicates instability.
//
// Costs: 2/3 n^3 per Newton step for n rows of closed points; about 25 n^3 / 3
// for the interior point method.
namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Returns @p points with the compliance @p share of the largest diagonal
    /// entry of @p W at each point, about the forces @p lambda.
    InterfacePoints
    softened(InterfacePoints        points,
             const PointCompliance &W,
             const double           share,
             const PointVectors    &lambda)
    {
      for (unsigned int i = 0; i < W.n_points(); ++i)
        {
          double most = 0.;
          for (unsigned int r = W.first[i]; r < W.first[i + 1]; ++r)
            most = std::max(most, W(r, r));
          points.compliance[i] = share * most;
          points.shift[i]      = share * most * lambda[i];
        }
      return points;
    }
  } // namespace



  InterfaceSolution
  solve_coulomb(const CoulombProblem &problem,
                const PointVectors   &start,
                const CoulombRules   &rules)
  {
    const PointCompliance &W = problem.compliance;
    DenseInterfaceSystem   system(W,
                                problem.q,
                                problem.about.empty() ?
                                    PointVectors(problem.q.size()) :
                                    problem.about);
    const InterfacePoints  exact = system.points(problem.friction);
    InterfaceSolution      best;
    best.force              = start;
    best.error              = std::numeric_limits<double>::max();
    PointVectors lambda     = start;
    unsigned int iterations = 0, idle = 0;
    double       compliance = rules.compliance;
    for (unsigned int round = 0; round < rules.max_rounds; ++round)
      {
        const InterfacePoints soft = softened(exact, W, compliance, lambda);
        InterfaceSolution     found =
          solve_interface(system, soft, lambda, {}, rules.interface);
        const double left = found.error;
        iterations += found.iterations;
        lambda = found.force;
        system.move_to(lambda);
        const LawError error = law_error(exact, lambda, system.lengths());
        found.error          = error.largest;
        found.states         = error.states;
        if (round > 0)
          found.by = best.by;
        const double before = best.error;
        idle                = found.error < best.error ? 0 : idle + 1;
        if (found.error < best.error)
          best = found;
        const bool is_slow = found.error > rules.slow * before,
                   is_last = compliance == rules.least_compliance;
        // Small forces gain digits after the tolerance is met.
        if (best.error < rules.interface.digits ||
            (best.error < rules.interface.tolerance && is_slow) ||
            (is_last && (left > rules.failed || idle == rules.idle)))
          break;
        if (is_slow)
          compliance =
            std::max(rules.least_compliance, rules.slow * compliance);
      }
    best.iterations = iterations;
    if (best.stability < 0)
      best.stability =
        stability_at(system,
                     softened(exact, W, rules.stability_compliance, best.force),
                     best.force);
    return best;
  }
} // namespace lamella
