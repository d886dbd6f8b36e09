// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/solve/friction_newton.h>
#include <lamella/solve/full_strategy.h>
#include <lamella/solve/interior_point.h>
#include <lamella/solve/sparse_interface_system.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

// Newton's method on displacements and forces of the whole scene with the
// penalty matrix K + K^p (Eqs. 22 and 23 of the paper): the semi-smooth Newton
// or primal-dual active set method (Hintermueller, Ito and Kunisch, SIAM J.
// Optim. 13 (2002) 865-888). Each round of solve():
// 1. step(): one Newton step on the current active set;
// 2. overlaps(): d lambda - (g + a lambda) of every row at the new iterate;
// 3. next_active_set(): drop tensile rows, add the worst penetrating ones;
// 4. if a set returns, energy_minimum() cuts the step (exact line search).
//
// The complementarity conditions are written as lambda = max(0, lambda - (g + a
// lambda) / d); its generalized derivative is 1 on the active set, 0 elsewhere.
namespace lamella
{
  namespace
  {
    bool
    contains_row(const std::vector<unsigned int> &ascending,
                 const unsigned int               row)
    {
      return std::binary_search(ascending.begin(), ascending.end(), row);
    }
  } // namespace



  FullStrategy::FullStrategy(const TangentOperator &tangent_operator,
                             const GapConstraints  &rows)
    : ContactStrategy(tangent_operator, rows)
    , matrix(tangent_operator,
             rows,
             rows.has_friction() ? Symmetry::none : Symmetry::definite)
  {}



  StrategyHistory
  FullStrategy::memory() const
  {
    return {numerical_compliance.stiffening, {matrix.known_rows()}};
  }



  void
  FullStrategy::restore(const StrategyHistory &memory)
  {
    numerical_compliance.stiffening = memory.stiffening;
    for (const std::vector<unsigned int> &known : memory.rows)
      matrix.restore(known);
  }



  // (K + K^p) du = r_u + B^T D^-1 r_lambda, dlambda = D^-1 (r_lambda - B du),
  // with D = diag(d) and, for slipping rows, the term mu e B_t^T D^-1 B_n.
  void
  FullStrategy::solve(const ActiveConstraints &closed,
                      const BlockVector       &r_u,
                      const Vector            &r_lambda,
                      BlockVector             &du,
                      Vector                  &dlambda)
  {
    const std::vector<unsigned int> &numbers = closed.numbers;
    const auto compliance                    = [&](const unsigned int number) {
      return numerical_compliance(rows[rows.row_of(number)]);
    };
    std::vector<PenaltyTerm> terms;
    for (const unsigned int number : numbers)
      terms.push_back({number, number, 1. / compliance(number)});
    for (const auto &[r, along] : closed.sliding)
      for (unsigned int a = 0; a < rows[r].slips.size(); ++a)
        terms.push_back({rows.slip(r, a), r, along[a] / compliance(r)});
    matrix.factorize(terms);

    du = r_u;
    std::vector<double> pushed(rows.size(), 0.);
    for (unsigned int k = 0; k < numbers.size(); ++k)
      {
        const double force = r_lambda[k] / compliance(numbers[k]);
        rows.constraint(numbers[k]).add_to(du, force);
        if (numbers[k] < rows.size())
          pushed[numbers[k]] = force;
      }
    for (const auto &[r, along] : closed.sliding)
      add_force(rows[r], 0., in_scene(rows[r], pushed[r] * along), du);
    du = matrix.solve(std::move(du));
    dlambda.reinit(numbers.size());
    for (unsigned int k = 0; k < numbers.size(); ++k)
      dlambda[k] = (r_lambda[k] - rows.constraint(numbers[k]).jump(du)) /
                   compliance(numbers[k]);
  }



  // ---- Newton's method

  // A set that is visited twice indicates a cycle of the active set.
  ContactSolution
  FullStrategy::solve(const ContactProblem &problem, const Monitor &monitor)
  {
    if (!problem.slip.empty())
      return solve_with_friction(problem, monitor);
    // Relative accuracy of one solution with K + K^p.
    constexpr double accurate = arithmetic::rounding_of_solutions;

    Iterate at = begin(problem);
    at.active  = next_active_set(at, overlaps(problem, at), problem.closed);
    std::set<std::vector<unsigned int>> visited;
    while (!at.active.empty() || !visited.empty())
      {
        const Iterate before = at;
        const double  change = step(problem, at);
        const double  closed =
          std::max(problem.closed,
                   std::min(accurate * at.du.linfty_norm(), change));
        const std::vector<double> overlap = overlaps(problem, at);
        const Round               round   = violating_rows(at, overlap, closed);
        monitor(round);
        if (round.changed.empty())
          break;
        if (visited.insert(at.active).second)
          at.active = next_active_set(at, overlap, closed);
        else
          at = energy_minimum(problem, before, at);
      }
    return {std::move(at.du), std::move(at.force), std::move(at.active)};
  }



  // Newton's method from the forces of the previous load step; without them, or
  // if it does not converge soon, from the result of the interior point.
  ContactSolution
  FullStrategy::solve_with_friction(const ContactProblem &problem,
                                    const Monitor        &monitor)
  {
    constexpr unsigned int near    = 12;
    const bool             is_warm = !problem.first_forces.empty() &&
                         largest_component(problem.first_forces) > 0.;
    FrictionNewton newton(tangent_operator, rows, numerical_compliance, matrix);
    if (const auto found = newton.solve(
          problem, newton.begin(problem), monitor, is_warm ? near : 0))
      return *found;

    FrictionNewton::Iterate start;
    {
      // Its matrix is released before Newton's method needs another.
      SparseInterfaceSystem system(tangent_operator,
                                   rows,
                                   numerical_compliance,
                                   problem);
      PointVectors          before(rows.size());
      for (unsigned int r = 0; r < rows.size(); ++r)
        {
          before[r][0] = problem.force[r];
          before[r][1] = problem.shear[r][0];
          before[r][2] = problem.shear[r][1];
        }
      start.force =
        solve_by_interior_point(system, system.points(), before, monitor);
      start.du     = std::move(system.du);
      start.K_du   = std::move(system.K_du);
      start.change = start.du.linfty_norm();
    }
    constexpr unsigned int until_monitor_ends =
      std::numeric_limits<unsigned int>::max();
    return *newton.solve(problem,
                         std::move(start),
                         monitor,
                         until_monitor_ends);
  }



  // Starts from the multiplier estimates of the rows expected to be active.
  FullStrategy::Iterate
  FullStrategy::begin(const ContactProblem &problem) const
  {
    Iterate at{tangent_operator.of().zero(),
               tangent_operator.of().zero(),
               std::vector<double>(rows.size(), 0.),
               problem.start};
    for (const unsigned int r : problem.start)
      at.force[r] = problem.estimate[r];
    return at;
  }



  // Both residuals are evaluated at the iterate, K du from strains, so that the
  // rounding of the factor does not accumulate over the rounds.
  double
  FullStrategy::step(const ContactProblem &problem, Iterate &at)
  {
    BlockVector r_u = tangent_operator.of().zero();
    r_u -= at.K_du;
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        if (!contains_row(at.active, r))
          at.force[r] = 0.;
        if (at.force[r] != problem.force[r])
          rows[r].add_to(r_u, at.force[r] - problem.force[r]);
      }
    Vector r_lambda(at.active.size());
    for (unsigned int k = 0; k < at.active.size(); ++k)
      {
        const unsigned int r = at.active[k];
        r_lambda[k]          = -(problem.gap[r] + rows[r].jump(at.du) +
                        law_compliance(rows[r]) * at.force[r]);
      }
    BlockVector du;
    Vector      dlambda;
    solve(at.active, r_u, r_lambda, du, dlambda);
    at.du += du;
    for (unsigned int k = 0; k < at.active.size(); ++k)
      at.force[at.active[k]] += dlambda[k];
    at.K_du = tangent_operator.apply(at.du);
    return du.linfty_norm();
  }



  // Complementarity function d lambda - (g + a lambda): positive in active
  // rows.
  std::vector<double>
  FullStrategy::overlaps(const ContactProblem &problem, const Iterate &at) const
  {
    std::vector<double> overlap;
    for (unsigned int r = 0; r < rows.size(); ++r)
      overlap.push_back(
        (numerical_compliance(rows[r]) - law_compliance(rows[r])) *
          at.force[r] -
        problem.gap[r] - rows[r].jump(at.du));
    return overlap;
  }



  bool
  FullStrategy::stays_active(const Iterate &at, const unsigned int row)
  {
    // The multiplier has the sign of the force up to rounding. The gap of a
    // hard penalty, from which the law gives the same force, has not.
    return contains_row(at.active, row) && at.force[row] >= 0.;
  }



  // Wrong rows: active and tensile, or inactive and penetrating.
  Round
  FullStrategy::violating_rows(const Iterate             &at,
                               const std::vector<double> &overlap,
                               const double               closed)
  {
    Round round{at.active.size(), {}, 0.};
    for (unsigned int r = 0; r < overlap.size(); ++r)
      if (contains_row(at.active, r) ? !stays_active(at, r) :
                                       overlap[r] > closed)
        {
          round.changed.push_back(r);
          round.violation = std::max(round.violation, std::abs(overlap[r]));
        }
    return round;
  }



  // Active set of the next step: max(0, .) of the complementarity function,
  // with a limit on the number of rows that join.
  std::vector<unsigned int>
  FullStrategy::next_active_set(const Iterate             &at,
                                const std::vector<double> &overlap,
                                const double               closed)
  {
    // Activating the worst penetrations first takes the fewest rounds if few of
    // many rows stay active.
    constexpr std::size_t                        few = 8;
    std::vector<unsigned int>                    next;
    std::vector<std::pair<double, unsigned int>> closing;
    for (unsigned int r = 0; r < overlap.size(); ++r)
      if (stays_active(at, r))
        next.push_back(r);
      else if (overlap[r] > closed && !contains_row(at.active, r))
        closing.emplace_back(overlap[r], r);
    std::sort(closing.rbegin(), closing.rend());
    closing.resize(std::min(closing.size(), std::max(few, at.active.size())));
    for (const auto &[over, r] : closing)
      next.push_back(r);
    std::sort(next.begin(), next.end());
    return next;
  }



  // Displacements are interpolated; forces follow from the law.
  FullStrategy::Iterate
  FullStrategy::interpolate_iterate(const ContactProblem &problem,
                                    const Iterate        &from,
                                    const Iterate        &to,
                                    const double          t) const
  {
    Iterate at = from;
    at.du.sadd(1. - t, t, to.du);
    at.K_du.sadd(1. - t, t, to.K_du);
    const std::vector<double> overlap = overlaps(problem, at);
    at.active.clear();
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        at.force[r] = std::max(0., overlap[r]) / numerical_compliance(rows[r]);
        if (overlap[r] > 0.)
          at.active.push_back(r);
      }
    return at;
  }



  // The energy along the step is convex and piecewise quadratic. Bisection on
  // its slope, the work of the unbalanced forces over the step.
  FullStrategy::Iterate
  FullStrategy::energy_minimum(const ContactProblem &problem,
                               const Iterate        &from,
                               const Iterate        &to) const
  {
    constexpr unsigned int enough    = 40;
    constexpr double       good_rest = 1e-2;

    BlockVector way = to.du;
    way -= from.du;
    // Slope of the energy, with changed sign; monotonically decreasing in t.
    const auto work = [&](const double t) {
      const Iterate at  = interpolate_iterate(problem, from, to, t);
      double        sum = -(at.K_du * way);
      for (unsigned int r = 0; r < rows.size(); ++r)
        if (at.force[r] != problem.force[r])
          sum += (at.force[r] - problem.force[r]) * rows[r].jump(way);
      return sum;
    };
    double       low = 0., high = 1., t = 1.;
    const double at_start = work(0.);
    for (unsigned int k = 0; k < enough; ++k)
      {
        const double w = work(t);
        if (std::abs(w) <= good_rest * std::abs(at_start) ||
            (t == 1. && w > 0.))
          break;
        (w > 0. ? low : high) = t;
        t                     = 0.5 * (low + high);
      }
    return interpolate_iterate(problem, from, to, t);
  }
} // namespace lamella
