// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/complementarity.h>
#include <lamella/solve/condensed_strategy.h>

#include <algorithm>
#include <set>

namespace lamella
{
  namespace
  {
    // Of the row's compliance, and of 1/penalty for a row between points that
    // supports hold, which has none.
    constexpr double smallest_softness = 1e-10, smallest_of_given = 1e-8;
    // How many rows take part from the start, at least.
    constexpr std::size_t first_rows = 8;
    // Rows that may idle beside active ones, and how many of these: below that
    // they cost next to nothing.
    constexpr std::size_t few_rows = 64, idle_for_each = 3;



    bool
    are_idle(const std::size_t n_rows, const std::size_t n_active)
    {
      return n_rows > few_rows && n_rows > (1 + idle_for_each) * n_active;
    }
  } // namespace



  CondensedStrategy::CondensedStrategy(const Linearisation &linearisation,
                                       const GapRows       &rows)
    : ContactStrategy(linearisation, rows)
    , compliance(linearisation, rows)
  {}



  double
  CondensedStrategy::softness(const unsigned int row) const
  {
    const double given = numerical_softness(rows[row]),
                 least = std::max(smallest_softness * compliance.diagonal(row),
                                  smallest_of_given * given);
    return rows[row].enforcement == Enforcement::exact ? least :
                                                         std::max(given, least);
  }



  void
  CondensedStrategy::solve(const std::vector<unsigned int> &active,
                           const BlockVector               &r_u,
                           const Vector                    &r_lambda,
                           BlockVector                     &du,
                           Vector                          &dlambda)
  {
    du = linearisation.solve(r_u);
    dlambda.reinit(active.size());
    if (active.empty())
      return;

    const std::size_t n = active.size();
    compliance.include(active);
    std::vector<double> d;
    for (const unsigned int r : active)
      d.push_back(softness(r));
    if (!factor || factorised_for != active || factorised_with != d)
      {
        std::vector<double> system = compliance.among(active);
        for (std::size_t i = 0; i < n; ++i)
          system[i * n + i] += d[i];
        factor.emplace(std::move(system), n, "The compliance of contact");
        factorised_for  = active;
        factorised_with = d;
      }
    std::vector<double> lambda(n);
    for (std::size_t i = 0; i < n; ++i)
      lambda[i] = r_lambda[i] - rows[active[i]].opening(du);
    factor->solve(lambda);
    std::copy(lambda.begin(), lambda.end(), dlambda.begin());
    du += compliance.displacement(active, lambda);
  }



  void
  CondensedStrategy::solve_part(const ContactProblem            &problem,
                                const std::vector<unsigned int> &part,
                                ContactSolution                 &solution)
  {
    // s = g_state + C (lambda - lambda_state) + a lambda +
    //     (d - a) (lambda - lambda_bar).
    const std::size_t      n = part.size();
    ComplementarityProblem small{compliance.among(part),
                                 std::vector<double>(n),
                                 problem.closed};
    std::vector<bool>      start(n);
    for (std::size_t i = 0; i < n; ++i)
      {
        const unsigned int r = part[i];
        const double       d = softness(r);
        small.q[i] =
          problem.gap[r] - (d - law_softness(rows[r])) * problem.estimate[r];
        for (std::size_t j = 0; j < n; ++j)
          small.q[i] -= small.matrix[j * n + i] * problem.force[part[j]];
        small.matrix[i * n + i] += d;
        start[i] =
          std::binary_search(solution.active.begin(), solution.active.end(), r);
      }
    const ComplementaritySolution found = solve_complementarity(small, start);

    std::vector<double> change(n);
    solution.active.clear();
    for (std::size_t i = 0; i < n; ++i)
      {
        solution.force[part[i]] = found.lambda[i];
        change[i]               = found.lambda[i] - problem.force[part[i]];
        if (found.active[i])
          solution.active.push_back(part[i]);
      }
    solution.du = compliance.displacement(part, change);
  }



  namespace
  {
    using Violations = std::vector<std::pair<double, unsigned int>>;



    /// The rows with gaps @p g below @p limit that are not among @p part.
    Violations
    rows_below(const double                     limit,
               const std::vector<unsigned int> &part,
               const std::vector<double>       &g)
    {
      Violations found;
      for (unsigned int r = 0; r < g.size(); ++r)
        if (g[r] < limit && !std::binary_search(part.begin(), part.end(), r))
          found.emplace_back(-g[r], r);
      std::sort(found.rbegin(), found.rend());
      return found;
    }



    Round
    round_of(const ContactSolution &solution, const Violations &wrong)
    {
      Round round{solution.active.size(),
                  {},
                  wrong.empty() ? 0. : wrong.front().first};
      for (const auto &[violation, r] : wrong)
        round.changed.push_back(r);
      return round;
    }
  } // namespace



  CondensedStrategy::Violations
  CondensedStrategy::touching_rows(const ContactProblem            &problem,
                                   const std::vector<unsigned int> &part,
                                   const std::vector<double>       &g) const
  {
    constexpr double closed_by_others = 100.;
    Violations       touching =
      rows_below(closed_by_others * problem.closed, part, g);
    touching.erase(std::remove_if(touching.begin(),
                                  touching.end(),
                                  [this](const auto &found) {
                                    return law_softness(rows[found.second]) >
                                           0.;
                                  }),
                   touching.end());
    return touching;
  }



  void
  CondensedStrategy::drop_idle(const ContactProblem      &problem,
                               const ContactSolution     &solution,
                               std::vector<unsigned int> &part,
                               std::set<unsigned int>    &left)
  {
    if (!are_idle(part.size(), solution.active.size()))
      return;
    const auto leaves = [&](const unsigned int r) {
      // What changes a force that was there has to stay in the sum.
      return solution.force[r] == 0. && problem.force[r] == 0. &&
             problem.estimate[r] == 0. && left.insert(r).second;
    };
    part.erase(std::remove_if(part.begin(), part.end(), leaves), part.end());
  }



  std::vector<unsigned int>
  CondensedStrategy::first_part(const ContactProblem &problem) const
  {
    std::set<unsigned int> part(problem.start.begin(), problem.start.end());
    for (unsigned int r = 0; r < rows.size(); ++r)
      if (problem.force[r] != 0. || problem.estimate[r] != 0.)
        part.insert(r);
    if (part.empty() && rows_below(-problem.closed, {}, problem.gap).empty())
      return {};
    std::vector<unsigned int> known;
    for (unsigned int r = 0; r < rows.size(); ++r)
      if (compliance.knows(r))
        known.push_back(r);
    if (!are_idle(known.size(), part.size()))
      part.insert(known.begin(), known.end());
    return {part.begin(), part.end()};
  }



  ContactSolution
  CondensedStrategy::settle(const ContactProblem &problem,
                            const Monitor        &monitor)
  {
    ContactSolution solution;
    solution.du     = linearisation.of().zero();
    solution.force  = problem.force;
    solution.active = problem.start;

    std::vector<unsigned int> part = first_part(problem);
    Violations joining = rows_below(-problem.closed, part, problem.gap);
    if (part.empty() && joining.empty())
      return solution;
    joining.resize(std::min(joining.size(), first_rows));

    std::set<unsigned int> left;
    bool                   all_that_touch = false;
    while (true)
      {
        for (const auto &[violation, r] : joining)
          for (std::vector<unsigned int> *set : {&part, &solution.active})
            set->insert(std::upper_bound(set->begin(), set->end(), r), r);
        compliance.include(part);
        solve_part(problem, part, solution);

        std::vector<double> g = problem.gap;
        for (unsigned int r = 0; r < rows.size(); ++r)
          g[r] += rows[r].opening(solution.du);
        joining = rows_below(-problem.closed, part, g);
        monitor(round_of(solution, joining));
        if (joining.empty() && !all_that_touch && !solution.active.empty())
          {
            joining        = touching_rows(problem, part, g);
            all_that_touch = true;
          }
        else
          joining.resize(
            std::min(joining.size(), std::max(first_rows, part.size())));
        if (joining.empty())
          break;
        drop_idle(problem, solution, part, left);
      }
    return solution;
  }



  StrategyMemory
  CondensedStrategy::memory() const
  {
    return {numerical_softness.stiffening, compliance.batches()};
  }



  void
  CondensedStrategy::recall(const StrategyMemory &memory)
  {
    numerical_softness.stiffening = memory.stiffening;
    for (const std::vector<unsigned int> &batch : memory.rows)
      compliance.include(batch);
  }

} // namespace lamella
