// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/estimate/bar_costs.h>
#include <lamella/estimate/enrichment.h>
#include <lamella/estimate/estimation.h>
#include <lamella/estimate/local_errors.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace lamella
{
  Estimation::Estimation(const Simulation    &run,
                         std::ostream        &out,
                         ModelCache          &cache,
                         const EstimateRules &rules)
    : rules(rules)
    , run(run)
    , out(out)
    , cache(cache)
    , others(run, out, cache)
  {}



  std::string
  Estimation::unavailable_reason() const
  {
    const GoalParameters &goals = run.model().scene().goals;
    if (std::string none = RunGoals::unavailable_reason(run); !none.empty())
      return none;
    if (goals.bars == ErrorBars::automatic &&
        !(operations_of_bars(run) <= rules.max_share_of_run * operations(run)))
      return "they would cost more than half of what the run does; --set "
             "\"Goals/Error bars=true\" makes them";
    return "";
  }



  double
  Estimation::share_of(const Step &step, const NamedQuantity &quantity) const
  {
    return models[step.to].numbers.value(quantity) -
           models[step.from].numbers.value(quantity);
  }



  double
  Estimation::weight_of(const Step &step) const
  {
    double       weight = 0.;
    unsigned int number = 0;
    for (const NamedQuantity &quantity : of_run->quantities())
      {
        const GoalResult without_error_bar =
          of_run->without_error_bar(number++);
        const double most =
          without_error_bar.tolerance ?
            rules.min_tolerance_share * without_error_bar.allowed_error() :
            rules.min_total_share * first_refinement(quantity).shares;
        if (most > 0.)
          weight = std::max(weight, std::abs(share_of(step, quantity)) / most);
      }
    return weight;
  }



  Refinements
  Estimation::first_refinement(const NamedQuantity &quantity) const
  {
    Refinements values;
    values.run    = models[0].numbers.value(quantity);
    values.richer = values.run;
    for (const Step &step : steps)
      {
        values.richer += share_of(step, quantity);
        values.shares += std::abs(share_of(step, quantity));
      }
    values.scale    = of_run->scale_of(quantity);
    values.rounding = of_run->rounding_of(quantity);
    return values;
  }



  std::vector<Source>
  Estimation::significant_sources() const
  {
    double largest = 0.;
    for (const Step &step : steps)
      if (step.source != Source::contact)
        largest = std::max(largest, weight_of(step));
    std::vector<Source> some;
    for (const Step &step : steps)
      if (step.source != Source::contact &&
          weight_of(step) >= std::min(1., largest))
        some.push_back(step.source);
    return some;
  }



  void
  Estimation::add_step(const Source source)
  {
    const Scene scene =
      enriched(models[base].scene, source, models[base].sizes);
    const std::string what = std::string("richer in ") + name_of(source);
    const auto        look = [this](const Simulation &finer) {
      local = errors_of(*of_run, run, finer);
    };
    // Duals give the errors along the axis; with friction there are none.
    const bool is_first =
      source == Source::axis && base == 0 && !has_source(scene, Source::path);
    const bool is_known = cache.find(scene) != nullptr;
    models.push_back(is_first && !is_known ? others.solved(scene, what, look) :
                                             others.solved(scene, what));
    const Step step{source, base, static_cast<unsigned int>(models.size() - 1)};
    steps.push_back(step);
    const bool matters =
      run.model().scene().goals.tolerances.empty() || weight_of(step) >= 1.;
    if (is_first && is_known && matters)
      others.solved(scene, what + " (again, for where)", look);
    if (matters)
      base = step.to;
  }



  void
  Estimation::solve_hierarchy()
  {
    cache.keep(models.front());
    for (const NameOf<Source> &source : Names<Source>::all)
      if (has_source(models[base].scene, source.value))
        add_step(source.value);
    solve_richest_model();
  }



  void
  Estimation::solve_richest_model()
  {
    const std::vector<Source> some = significant_sources();
    before_richest                 = base;
    // A single source is refined again right after its first refinement: the
    // later ones in the chain do not matter.
    for (const Step &step : steps)
      if (some.size() == 1 && some.front() == step.source)
        before_richest = step.to;
    // LE in place of other fields gets a richer, possibly known, section.
    std::vector<Source> refined;
    for (Source source : some)
      {
        if (!has_source(models[before_richest].scene, source))
          source = Source::section;
        if (std::find(refined.begin(), refined.end(), source) == refined.end())
          refined.push_back(source);
      }
    Scene       scene = models[before_richest].scene;
    std::string what;
    for (const Source source : refined)
      {
        scene = enriched(scene, source, models[before_richest].sizes);
        what += std::string(what.empty() ? "" : ", ") + name_of(source);
      }
    models.push_back(others.solved(scene, "once more in " + what));
  }



  ErrorBar
  Estimation::error_bar_of(const NamedQuantity &quantity) const
  {
    Refinements values = first_refinement(quantity);
    values.richest     = values.richer + models.back().numbers.value(quantity) -
                     models[before_richest].numbers.value(quantity);
    return error_bar(values, rules);
  }



  GoalResult
  Estimation::goal(const NamedQuantity &quantity,
                   const unsigned int   number) const
  {
    GoalResult result =
      failure.empty() ? of_run->with_error_bar(number, error_bar_of(quantity)) :
                        of_run->without_error_bar(number);
    if (!local.empty())
      result.local = local.at(number);
    if (!failure.empty())
      result.why = failure;
    else
      for (const Step &step : steps)
        result.shares.emplace_back(name_of(step.source),
                                   share_of(step, quantity));
    return result;
  }



  std::vector<GoalResult>
  Estimation::goals()
  {
    if (!unavailable_reason().empty())
      return {};
    out << "Error bars, from richer models of the scene:" << std::endl;
    of_run = std::make_unique<RunGoals>(run);
    models = {
      Model{for_estimates(run), of_run->numbers(), sizes_of(run.model())}};
    // A failure of another model must not discard the results of the run.
    if (const Outcome outcome = outcome_of([this] { solve_hierarchy(); });
        outcome.status != 0)
      {
        failure =
          "a richer model has no result (" + trimmed(outcome.message) + ")";
        out << "failed" << std::endl;
      }
    std::vector<GoalResult> results;
    for (const NamedQuantity &quantity : of_run->quantities())
      results.push_back(goal(quantity, results.size()));
    return results;
  }
} // namespace lamella
