// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/estimate/contact_shares.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  namespace
  {
    bool
    has_small_rotations_and(const Source source, const Scene &scene)
    {
      return has_source(scene, source) &&
             scene.solve.rotations != Rotations::large;
    }
  } // namespace



  ContactShares::ContactShares(const Simulation    &run,
                               const EstimateRules &rules)
    : rules(rules)
    , any_penalty(has_small_rotations_and(Source::contact, run.model().scene()))
    , any_friction(has_small_rotations_and(Source::path, run.model().scene()))
  {
    // States with friction depend on the path: coarser models are solved.
    if (!any_penalty || any_friction)
      return;
    std::vector<GapConstraint> rows(run.model().rows().begin(),
                                    run.model().rows().end());
    for (GapConstraint &row : rows)
      row.enforcement = Enforcement::exact;
    const GapConstraints view(rows);
    const auto          &given = run.model().scene().solve;
    LinearSystem         system(run.linear_system().shared_tangent(),
                        view,
                        given.nonlinear,
                        choose_strategy(given.strategy,
                                        run.model().structure(),
                                        view));
    const auto          &last   = run.results().last();
    const LoadFactor    &factor = last.load_factor;
    const State          without =
      NonlinearSolver(system, given.nonlinear).solve(factor, last.state).state;

    u = without.u;
    u -= last.state.u;
    std::vector<unsigned int> touching;
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        const double now = without.active.empty() ? 0. : without.force[r],
                     before =
                       last.state.active.empty() ? 0. : last.state.force[r];
        force.push_back(now - before);
        if (now != 0. || before != 0.)
          touching.push_back(r);
      }
    dual = std::make_unique<const GoalDual>(run, touching);
  }



  void
  ContactShares::compare(const std::vector<NamedQuantity> &goals,
                         ComparisonModels                 &others,
                         const Scene                      &poorer,
                         const ResultNumbers              &numbers)
  {
    poor = numbers;
    const bool wants_models =
      std::any_of(goals.begin(),
                  goals.end(),
                  [this](const NamedQuantity &goal) {
                    return dual == nullptr || !dual->derivative(goal);
                  });
    if (any_penalty && wants_models)
      exact =
        others.solved(enriched(poorer, Source::contact, {}), "no penetration")
          .numbers;
    if (any_friction)
      shorter =
        others
          .solved(enriched(poorer, Source::path, {}), "twice as many substeps")
          .numbers;
  }



  double
  ContactShares::of_penalties(const NamedQuantity &goal) const
  {
    const auto derivative =
      dual == nullptr ? std::nullopt : dual->derivative(goal);
    if (!derivative)
      return exact->value(goal) - poor->value(goal);
    double      sum    = derivative->u * u;
    const auto &active = dual->active_rows();
    for (unsigned int k = 0; k < active.size(); ++k)
      sum += derivative->force[k] * force[active[k]];
    return sum;
  }



  void
  ContactShares::add_to(const NamedQuantity &goal, GoalResult &result) const
  {
    const auto add =
      [&result](const Source source, const double error, const double most) {
        result.estimate += error;
        result.bar += std::abs(most);
        result.shares.emplace_back(name_of(source), most);
      };
    if (any_penalty)
      {
        const double change = of_penalties(goal);
        add(Source::contact, change, rules.safety * change);
      }
    if (any_friction)
      {
        const double change = shorter->value(goal) - poor->value(goal);
        add(Source::path, rules.safety * change, rules.of_path * change);
      }
  }
} // namespace lamella
