// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/factorisation.h>
#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/solve/full_strategy.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace lamella
{
  using namespace dealii;

  FullStrategy::FullStrategy(const Structure           &structure,
                             const std::vector<GapRow> &rows)
    : ContactStrategy(structure, rows)
  {}



  Row
  FullStrategy::global_row(const GapRow &row) const
  {
    const auto &blocks = structure.load().get_block_indices();
    Row         result;
    for (const BodyRow &part : row.parts)
      {
        const Row free =
          part.row.reduced(structure.reduction(part.body).constraints());
        for (const auto &[dof, weight] : free.entries())
          result.add(blocks.local_to_global(part.body, dof), weight);
      }
    result.compress();
    return result;
  }



  void
  FullStrategy::factorise(const std::vector<unsigned int> &active)
  {
    const auto   &blocks = structure.load().get_block_indices();
    UpperTriangle matrix;
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      structure.bodies()[b]->stiffness().for_each_entry(
        [&](const DofIndex row, const DofIndex column, const double value) {
          matrix.add(blocks.local_to_global(b, row),
                     blocks.local_to_global(b, column),
                     value);
        });
    // k^p = eps n^T n (Eq. 23), with the row in place of n, once for all
    // processes.
    if (is_speaker())
      for (const unsigned int r : active)
        {
          const Row row = global_row(rows[r]);
          for (const auto &[i, weight] : row.entries())
            for (const auto &[j, other] : row.entries())
              matrix.add(i, j, weight * other / numerical_softness(rows[r]));
        }
    solver.reset();
    solver         = factorise_shared(structure.n_dofs(),
                              std::move(matrix),
                              "the scene with its penalties");
    factorised_for = active;
  }



  void
  FullStrategy::solve(const std::vector<unsigned int> &active,
                      const BlockVector               *r_u,
                      const Vector                    &r_lambda,
                      BlockVector                     &du,
                      Vector                          &dlambda)
  {
    std::vector<double> d;
    for (const unsigned int r : active)
      d.push_back(numerical_softness(rows[r]));
    if (solver == nullptr || factorised_for != active || factorised_with != d)
      {
        factorise(active);
        factorised_with = d;
        measure_hardness(active);
      }

    // (K + K^p) du = r_u + B^T r_lambda / d.
    du = r_u == nullptr ? structure.zero() : *r_u;
    for (unsigned int k = 0; k < active.size(); ++k)
      rows[active[k]].add_to(du, r_lambda[k] / d[k]);
    structure.condense(du);

    Vector x(du.size());
    std::copy(du.begin(), du.end(), x.begin());
    solver->solve(x);
    std::copy(x.begin(), x.end(), du.begin());
    for (unsigned int body = 0; body < structure.bodies().size(); ++body)
      structure.reduction(body).constraints().distribute(du.block(body));

    dlambda.reinit(active.size());
    for (unsigned int k = 0; k < active.size(); ++k)
      dlambda[k] = (r_lambda[k] - rows[active[k]].opening(du)) / d[k];
  }



  void
  FullStrategy::measure_hardness(const std::vector<unsigned int> &active)
  {
    std::vector<Vector> diagonals;
    for (const auto &body : structure.bodies())
      diagonals.push_back(body->stiffness().diagonal());
    for (const unsigned int r : active)
      {
        double softness = 0.;
        for (const BodyRow &part : rows[r].parts)
          {
            const Row free =
              part.row.reduced(structure.reduction(part.body).constraints());
            for (const auto &[dof, weight] : free.entries())
              softness += weight * weight / diagonals[part.body][dof];
          }
        const double penalty = 1. / numerical_softness(rows[r]);
        if (softness * penalty > hardest)
          {
            hardest         = softness * penalty;
            hardest_penalty = penalty;
          }
      }
  }



  std::vector<std::string>
  FullStrategy::warnings() const
  {
    // Rounding leaves an error of about N t eps / k (Nour-Omid and Wriggers,
    // 1987), least together with the penalty's own k / eps at k / sqrt(N t).
    const double t = std::numeric_limits<double>::epsilon(),
                 n = structure.n_dofs(), rounding = n * t * hardest;
    if (rounding < 1e-4)
      return {};
    return {"the penalty " + to_text(hardest_penalty, 3) + " is " +
            to_text(hardest, 2) +
            " times the stiffness of the DoFs it acts on; in K + K^p of " +
            std::to_string(structure.n_dofs()) +
            " DoFs double precision holds about " +
            to_text(hardest_penalty / hardest / std::sqrt(n * t), 2) +
            " best, and what was found may be off by " + to_text(rounding, 1) +
            ": take a softer Penalty or the condensed strategy"};
  }



  double
  FullStrategy::overlap(const ContactProblem &problem,
                        const unsigned int    r,
                        const double          gap) const
  {
    return (numerical_softness(rows[r]) - law_softness(rows[r])) *
             problem.estimate[r] -
           gap;
  }



  FullStrategy::Iterate
  FullStrategy::newton_point(const ContactProblem            &problem,
                             const std::vector<unsigned int> &active)
  {
    BlockVector r_u = structure.zero();
    for (unsigned int r = 0; r < rows.size(); ++r)
      if (problem.force[r] != 0.)
        rows[r].add_to(r_u, -problem.force[r]);
    Vector r_lambda(active.size()), lambda;
    for (unsigned int k = 0; k < active.size(); ++k)
      r_lambda[k] = overlap(problem, active[k], problem.gap[active[k]]);

    Iterate point;
    solve(active, &r_u, r_lambda, point.du, lambda);
    point.force.assign(rows.size(), 0.);
    for (unsigned int k = 0; k < active.size(); ++k)
      point.force[active[k]] = lambda[k];
    point.gap = problem.gap;
    for (unsigned int r = 0; r < rows.size(); ++r)
      point.gap[r] += rows[r].opening(point.du);
    return point;
  }



  double
  FullStrategy::slope(const ContactProblem &problem,
                      const Iterate        &from,
                      const Iterate        &to,
                      const double          t) const
  {
    // The forces that hold the displacements less those of the law, times the
    // change of the gaps.
    double sum = 0.;
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        const double held = from.force[r] + t * (to.force[r] - from.force[r]),
                     g    = from.gap[r] + t * (to.gap[r] - from.gap[r]);
        const double law =
          std::max(0., overlap(problem, r, g)) / numerical_softness(rows[r]);
        sum += (held - law) * (to.gap[r] - from.gap[r]);
      }
    return sum;
  }



  double
  FullStrategy::lowest_point(const ContactProblem &problem,
                             const Iterate        &from,
                             const Iterate        &to) const
  {
    // The slope is linear between the places where a row opens or closes.
    std::vector<double> breaks{0.};
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        const double t =
          overlap(problem, r, from.gap[r]) / (to.gap[r] - from.gap[r]);
        if (t > 0. && std::isfinite(t))
          breaks.push_back(t);
      }
    std::sort(breaks.begin(), breaks.end());
    std::size_t low = 0, high = breaks.size();
    while (high - low > 1)
      {
        const std::size_t middle = (low + high) / 2;
        (slope(problem, from, to, breaks[middle]) < 0. ? low : high) = middle;
      }
    const double a    = breaks[low],
                 b    = high < breaks.size() ? breaks[high] : 2. * a + 1.;
    const double at_a = slope(problem, from, to, a),
                 at_b = slope(problem, from, to, b);
    return at_a < 0. && at_b > at_a ? a - at_a * (b - a) / (at_b - at_a) : 0.;
  }



  Round
  FullStrategy::compare(const ContactProblem            &problem,
                        const std::vector<unsigned int> &active,
                        const std::vector<double>       &gap) const
  {
    Round round{active.size(), {}, 0.};
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        const double over = overlap(problem, r, gap[r]);
        if (std::abs(over) > problem.closed &&
            std::binary_search(active.begin(), active.end(), r) != (over > 0.))
          {
            round.changed.push_back(r);
            round.violation = std::max(round.violation, std::abs(over));
          }
      }
    return round;
  }



  std::vector<unsigned int>
  FullStrategy::next_set(const ContactProblem            &problem,
                         const std::vector<unsigned int> &active,
                         const std::vector<double>       &gap) const
  {
    constexpr std::size_t                        few = 8;
    std::vector<unsigned int>                    next;
    std::vector<std::pair<double, unsigned int>> closing;
    for (unsigned int r = 0; r < rows.size(); ++r)
      if (const double over = overlap(problem, r, gap[r]); over > 0.)
        {
          if (std::binary_search(active.begin(), active.end(), r))
            next.push_back(r);
          else if (over > problem.closed)
            closing.emplace_back(over, r);
        }
    std::sort(closing.rbegin(), closing.rend());
    closing.resize(std::min(closing.size(), std::max(few, active.size())));
    for (const auto &[over, r] : closing)
      next.push_back(r);
    std::sort(next.begin(), next.end());
    return next;
  }



  ContactSolution
  FullStrategy::settle(const ContactProblem &problem, const Monitor &monitor)
  {
    Iterate                   now{structure.zero(), problem.force, problem.gap};
    std::vector<unsigned int> active = problem.start.empty() ?
                                         next_set(problem, {}, problem.gap) :
                                         problem.start;
    const bool                untouched =
      active.empty() && std::all_of(problem.force.begin(),
                                    problem.force.end(),
                                    [](const double f) { return f == 0.; });
    if (untouched)
      return {now.du, now.force, {}};

    // The worst penetrations first settles soonest where few rows of many stay
    // active; should a set come back, the energy takes over.
    std::set<std::vector<unsigned int>> visited;
    while (true)
      {
        const Iterate next  = newton_point(problem, active);
        const Round   round = compare(problem, active, next.gap);
        monitor(round);
        if (round.changed.empty())
          return {next.du, next.force, active};
        if (visited.insert(active).second)
          active = next_set(problem, active, next.gap);
        else
          {
            const double t = lowest_point(problem, now, next);
            now.du.sadd(1. - t, t, next.du);
            for (unsigned int r = 0; r < rows.size(); ++r)
              {
                now.force[r] += t * (next.force[r] - now.force[r]);
                now.gap[r] += t * (next.gap[r] - now.gap[r]);
              }
            active.clear();
            for (unsigned int r = 0; r < rows.size(); ++r)
              if (overlap(problem, r, now.gap[r]) > 0.)
                active.push_back(r);
          }
      }
  }
} // namespace lamella
