// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/coulomb.h>
#include <lamella/solve/dense_interface_system.h>

#include <algorithm>

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
    best.force             = start;
    PointVectors lambda    = start;
    unsigned int idle      = 0;
    auto         costliest = InterfaceMethod::newton;
    double       share     = rules.compliance;
    for (unsigned int round = 0; round < rules.max_rounds; ++round)
      {
        InterfaceSolution found = solve_interface(
          system, softened(exact, share, lambda), lambda, {}, rules.interface);
        const double left = found.error, before = best.error;
        lambda = found.force;
        system.move_to(lambda);
        const LawError error = law_error(exact, lambda, system.lengths());
        found.error          = error.largest;
        found.states         = error.states;
        costliest = found.by = std::max(costliest, found.by);
        best.offer(found);
        idle               = found.error < before ? 0 : idle + 1;
        const bool is_slow = found.error > rules.slow * before,
                   is_last = share == rules.least_compliance;
        // Small forces gain digits after the tolerance is met.
        if (best.error < rules.interface.digits ||
            (best.error < rules.interface.tolerance && is_slow) ||
            (is_last && (left > rules.failed || idle == rules.idle)))
          break;
        if (is_slow)
          share = std::max(rules.least_compliance, rules.slow * share);
      }
    best.by = costliest;
    if (best.stability < 0)
      best.stability =
        stability_at(system,
                     softened(exact, rules.stability_compliance, best.force),
                     best.force);
    return best;
  }
} // namespace lamella
