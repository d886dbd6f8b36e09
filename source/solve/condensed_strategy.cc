// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/complementarity.h>
#include <lamella/solve/condensed_strategy.h>

#include <algorithm>
#include <set>

namespace lamella
{
  namespace
  {
    constexpr double smallest_softness = 1e-10;
    // How many rows take part from the start, at least.
    constexpr std::size_t first_rows = 8;



    /// Rows that miss the law, the worst first, each with its gap's violation.
    using Violations = std::vector<std::pair<double, unsigned int>>;
  } // namespace



  CondensedStrategy::CondensedStrategy(const Structure           &structure,
                                       const std::vector<GapRow> &rows)
    : ContactStrategy(structure, rows)
    , compliance(structure, rows)
  {}



  double
  CondensedStrategy::softness(const unsigned int row) const
  {
    return std::max(rows[row].enforcement == Enforcement::exact ?
                      0. :
                      numerical_softness(rows[row]),
                    smallest_softness * compliance(row, row));
  }



  BlockVector
  CondensedStrategy::apply_inverse(BlockVector r) const
  {
    structure.condense(r);
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      {
        structure.bodies()[b]->factorisation().solve(r.block(b));
        structure.reduction(b).constraints().distribute(r.block(b));
      }
    return r;
  }



  void
  CondensedStrategy::solve(const std::vector<unsigned int> &active,
                           const BlockVector               *r_u,
                           const Vector                    &r_lambda,
                           BlockVector                     &du,
                           Vector                          &dlambda)
  {
    du = r_u == nullptr ? structure.zero() : apply_inverse(*r_u);
    dlambda.reinit(active.size());
    if (active.empty())
      return;

    const std::size_t n = active.size();
    if (!factor || factorised_for != active)
      {
        compliance.include(active);
        std::vector<double> system(n * n);
        for (std::size_t j = 0; j < n; ++j)
          {
            for (std::size_t i = j; i < n; ++i)
              system[j * n + i] = compliance(active[i], active[j]);
            system[j * n + j] += softness(active[j]);
          }
        factor.emplace(std::move(system), n, "The compliance of contact");
        factorised_for = active;
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
    ComplementarityProblem small{std::vector<double>(n * n),
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
          {
            small.matrix[j * n + i] = compliance(r, part[j]);
            small.q[i] -= small.matrix[j * n + i] * problem.force[part[j]];
          }
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
    /// The rows that would penetrate at gaps @p g and are not among @p part.
    Violations
    violations_outside(const std::vector<unsigned int> &part,
                       const std::vector<double>       &g,
                       const double                     closed)
    {
      Violations violations;
      for (unsigned int r = 0; r < g.size(); ++r)
        if (g[r] < -closed && !std::binary_search(part.begin(), part.end(), r))
          violations.emplace_back(-g[r], r);
      std::sort(violations.rbegin(), violations.rend());
      return violations;
    }
  } // namespace



  ContactSolution
  CondensedStrategy::settle(const ContactProblem &problem,
                            const Monitor        &monitor)
  {
    ContactSolution solution;
    solution.du     = structure.zero();
    solution.force  = problem.force;
    solution.active = problem.start;

    std::set<unsigned int> part(problem.start.begin(), problem.start.end());
    for (unsigned int r = 0; r < rows.size(); ++r)
      if (problem.force[r] != 0. || problem.estimate[r] != 0.)
        part.insert(r);
    std::vector<unsigned int> sorted(part.begin(), part.end());
    Violations wrong = violations_outside(sorted, problem.gap, problem.closed);
    wrong.resize(std::min(wrong.size(), first_rows));
    while (!sorted.empty() || !wrong.empty())
      {
        for (const auto &[violation, r] : wrong)
          {
            part.insert(r);
            solution.active.push_back(r);
          }
        std::sort(solution.active.begin(), solution.active.end());
        sorted.assign(part.begin(), part.end());
        compliance.include(sorted);
        solve_part(problem, sorted, solution);

        std::vector<double> g = problem.gap;
        for (unsigned int r = 0; r < rows.size(); ++r)
          g[r] += rows[r].opening(solution.du);
        wrong = violations_outside(sorted, g, problem.closed);
        Round round{solution.active.size(), {}, 0.};
        for (const auto &[violation, r] : wrong)
          round.changed.push_back(r);
        round.violation = wrong.empty() ? 0. : wrong.front().first;
        monitor(round);
        if (wrong.empty())
          break;
        // As many as have proved active, and half of those that take part, so
        // that the number of rounds stays a logarithm.
        wrong.resize(std::min(
          wrong.size(),
          std::max({first_rows, solution.active.size(), part.size() / 2})));
      }
    return solution;
  }



  double
  CondensedStrategy::condition_estimate() const
  {
    double largest = 0.;
    for (const auto &body : structure.bodies())
      largest = std::max(largest, body->factorisation().condition_estimate());
    return largest;
  }
} // namespace lamella
