// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/estimate/comparison.h>
#include <lamella/estimate/estimation.h>

#include <algorithm>
#include <cmath>
#include <ostream>

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



    /// Raises the mesh part of the bar of @p goal to at least twice its change
    /// @p missed by short elements at supports. Contact parts are added.
    void
    raise_at_supports(const double missed,
                      const double safety,
                      GoalResult  &goal)
    {
      const double whole = safety * missed;
      goal.least         = std::abs(whole);
      if (!(goal.least > goal.bar))
        return;
      goal.bar      = goal.least;
      goal.estimate = missed;
      for (auto &[source, share] : goal.shares)
        if (source == name_of(Source::axis))
          share = whole;
    }



    bool
    lacks(const NamedQuantity              &quantity,
          const std::vector<ResultNumbers> &models)
    {
      return std::any_of(models.begin(), models.end(), [&](const auto &model) {
        return !model.has(quantity);
      });
    }



    /// Returns the goals of @p run with bars by @p recipe, or the reason why
    /// its models fail: this must not discard the results of the run.
    GoalBars
    bars_by_recipe(const Simulation    &run,
                   const Recipe        &recipe,
                   std::ostream        &out,
                   ModelCache          &cache,
                   const EstimateRules &rules)
    {
      out << "Error bars, from " << recipe.from << ":" << std::endl;
      GoalBars      bars{{}, "", recipe.from};
      const Outcome outcome = outcome_of([&] {
        bars.goals = Comparison(run, recipe, out, cache, rules).goals();
      });
      if (outcome.status != 0)
        {
          const std::string why = strip_period(trimmed(outcome.message));
          out << "  failed: " << why << "." << std::endl;
          bars.missing_reason = recipe.from + " have no result (" + why + ")";
        }
      return bars;
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



  Comparison::Comparison(const Simulation    &run,
                         const Recipe        &recipe,
                         std::ostream        &out,
                         ModelCache          &cache,
                         const EstimateRules &rules)
    : run(run)
    , rules(rules)
    , recipe(recipe)
    , of_run(run)
    , dual(run)
    , of_contact(run, rules)
  {
    derivatives.resize(of_run.quantities().size());
    if (recipe.has_surpluses)
      {
        surpluses = std::make_unique<const Surpluses>(run);
        for (unsigned int k = 0; k < derivatives.size(); ++k)
          derivatives[k] = dual.derivative(of_run.quantities()[k]);
      }
    bool any = false;
    for (unsigned int k = 0; k < derivatives.size(); ++k)
      any = any || needs_models(k);
    if (any)
      solve_models(out, cache);
    solve_at_supports(out, cache);
  }



  bool
  Comparison::needs_models(const unsigned int number) const
  {
    return !run.model().scene().contacts.empty() || !derivatives[number];
  }



  void
  Comparison::solve_models(std::ostream &out, ModelCache &cache)
  {
    ComparisonModels others(run, out, cache);
    const auto       look = [this](const Simulation &finer) {
      local = errors_of(of_run, run, finer);
    };
    for (const auto &[what, scene, is_for_elements] : recipe.models)
      results.push_back((is_for_elements ? others.solved(scene, what, look) :
                                           others.solved(scene, what))
                          .numbers);
    if (recipe.of_contact)
      of_contact.compare(of_run.quantities(),
                         others,
                         recipe.models[*recipe.of_contact].scene,
                         results[*recipe.of_contact]);
  }



  void
  Comparison::solve_at_supports(std::ostream &out, ModelCache &cache)
  {
    const Outcome outcome = outcome_of([&] {
      ComparisonModels others(run, out, cache);
      for (const ComparisonModel &model : models_at_supports(run, rules))
        at_supports.push_back(others.solved(model.scene, model.what).numbers);
    });
    if (outcome.status == 0)
      return;
    at_supports.clear();
    out << "  failed: " << trimmed(outcome.message) << std::endl;
  }



  std::optional<SurplusParts>
  Comparison::surplus_of(const unsigned int number) const
  {
    if (!derivatives[number])
      return {};
    BlockVector z = dual.solve(*derivatives[number]).u;
    if (const auto w = dual.lifting(of_run.quantities()[number]))
      z -= *w;
    return surpluses->of(z);
  }



  ComparedValues
  Comparison::values_of(const unsigned int number) const
  {
    const NamedQuantity &goal = of_run.quantities()[number];
    ComparedValues       values;
    values.run      = of_run.numbers().value(goal);
    values.scale    = of_run.scale_of(goal);
    values.rounding = of_run.rounding_of(goal);
    values.surplus  = surplus_of(number);
    if (needs_models(number))
      for (const ResultNumbers &result : results)
        values.models.push_back(result.value(goal));
    return values;
  }



  std::vector<GoalResult>
  Comparison::goals() const
  {
    std::vector<GoalResult> goals;
    for (unsigned int k = 0; k < of_run.quantities().size(); ++k)
      {
        const NamedQuantity &quantity = of_run.quantities()[k];
        if (lacks(quantity, results) || lacks(quantity, at_supports) ||
            !of_contact.has(quantity))
          {
            goals.push_back(of_run.without_error_bar(k));
            goals.back().why = no_similar_mode;
            continue;
          }
        const ComparedValues values = values_of(k);
        const ErrorBar       bar    = recipe.bar(values);
        GoalResult &goal = goals.emplace_back(of_run.with_error_bar(k, bar));
        goal.shares      = bar.shares;
        if (values.surplus)
          goal.local = values.surplus->along_axis;
        else if (!local.empty())
          goal.local = local[k];
        if (!at_supports.empty())
          raise_at_supports(at_supports[1].value(quantity) -
                              at_supports[0].value(quantity),
                            rules.safety,
                            goal);
        of_contact.add_to(quantity, goal);
      }
    return goals;
  }



  GoalBars
  error_bars_of(const Simulation    &run,
                std::ostream        &out,
                ModelCache          &cache,
                const EstimateRules &rules)
  {
    if (const std::string why = RunGoals::unavailable_reason(run); !why.empty())
      return {{}, why, ""};
    const Scene &scene    = run.model().scene();
    const bool   is_large = scene.solve.rotations == Rotations::large;
    Recipe       recipe;
    if (is_large || scene.goals.bars != ErrorBars::richer)
      recipe = choose_recipe(run, rules);
    GoalBars bars;
    if (recipe.bar)
      bars = bars_by_recipe(run, recipe, out, cache, rules);
    // There are no finer models with large rotations.
    if (is_large && !recipe.bar)
      return {{}, recipe.unavailable, ""};
    if (is_large || !bars.goals.empty())
      return bars;
    Estimation        estimation(run, out, cache, rules);
    const std::string none = estimation.unavailable_reason();
    if (none.empty())
      return {estimation.goals(), "", ""};
    return {{},
            (bars.missing_reason.empty() ?
               "" :
               bars.missing_reason + ", and of richer ones: ") +
              none,
            ""};
  }
} // namespace lamella
