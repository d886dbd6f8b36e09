// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/sentence.h>
#include <lamella/base/text.h>
#include <lamella/estimate/comparison.h>
#include <lamella/estimate/estimation.h>
#include <lamella/estimate/local_errors.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace lamella
{
  namespace
  {
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
  } // namespace



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
        const ComparedValues values   = values_of(k);
        const ErrorBar       bar      = recipe.bar(values);
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



  namespace
  {
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
