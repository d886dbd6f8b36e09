// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/local_interactions.h>
#include <lamella/base/text.h>
#include <lamella/estimate/error_bar.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  namespace
  {
    /// Returns why successive changes @p first and @p second give no bar.
    std::string
    distrust_reason(const double         first,
                    const double         second,
                    const double         scale,
                    const EstimateRules &rules)
    {
      if (first * second > rules.growth * first * first)
        return "the quantity changes more in each refinement, by " +
               to_text(100. * std::abs(first) / scale, 2) + " and then by " +
               to_text(100. * std::abs(second) / scale, 2) + " %" +
               describe_growth();
      return "two refinements do not agree: one changes the quantity by " +
             to_text(100. * first / scale, 2) + " %, the next by " +
             to_text(100. * second / scale, 2) + " %. Refine theory or mesh";
    }
  } // namespace



  std::string
  describe_growth()
  {
    return ", as at a singularity (a point load, the edge of a clamp, the "
           "corner of a punch). Move the probe away from such points";
  }



  ErrorBar
  error_bar(const Refinements &values, const EstimateRules &rules)
  {
    const double first  = values.richer - values.run,
                 second = values.richest - values.richer;
    ErrorBar result;
    result.estimate = values.richest - values.run;
    const double spread =
      std::max({std::abs(first), std::abs(second), std::abs(result.estimate)});
    const double rounding =
      std::max(values.rounding, rules.digits * values.scale);
    result.bar = std::max({rules.safety * std::abs(result.estimate),
                           rules.of_shares * values.shares,
                           rounding});

    if (std::abs(second) <= rules.max_remaining_share * std::abs(first) ||
        spread <= rounding)
      result.trusted = true;
    else if (spread <= rules.small * values.scale)
      {
        result.trusted = true;
        result.bar     = std::max(result.bar, rules.safety * spread);
      }
    else
      result.why = distrust_reason(first, second, values.scale, rules);
    return result;
  }



  ErrorBar
  coarser_model_bar(const std::vector<Levels> &sources,
                    const double               scale,
                    const double               rounding,
                    const EstimateRules       &rules)
  {
    ErrorBar result;
    result.trusted = true;
    for (const Levels &levels : sources)
      {
        const double d = std::abs(levels.last), e = std::abs(levels.before);
        const bool   contracts = e > 0. && d <= rules.max_remaining_share * e;
        const double left      = contracts ? (d / e) / (1. - d / e) : 1.;
        result.estimate += levels.last * left;
        result.parts.push_back(
          contracts ? std::max({d, rules.safety * d * left, levels.least}) :
                      std::max(rules.safety * std::max(d, e), levels.least));
        result.bar += result.parts.back();
        if (!contracts && std::max(d, e) > rules.small * scale)
          {
            result.trusted = false;
            result.why     = distrust_reason(e, d, scale, rules);
          }
      }
    result.bar = std::max({result.bar, rounding, rules.digits * scale});
    return result;
  }



  std::string
  RunGoals::unavailable_reason(const Simulation &run)
  {
    const GoalParameters &goals = run.model().scene().goals;
    if (!goals.any())
      return "the scene has neither Quantities in Goals nor probes";
    if (goals.bars == ErrorBars::never)
      return "Error bars = false, in Goals";
    if (goals.bars == ErrorBars::automatic &&
        run.model().scene().solve.rotations == Rotations::large)
      return "at large rotations they take another run, on a coarser axis; "
             "--set \"Goals/Error bars=true\" makes them";
    return "";
  }



  RunGoals::RunGoals(const Simulation &run, const GoalRules &rules)
    : run(run)
    , rules(rules)
    , values(run.results())
  {
    const GoalParameters &goals = run.model().scene().goals;
    // A mode may not be found; tolerances belong to goals by their order.
    for (const NamedQuantity &quantity : goals.quantities)
      if (goals.tolerances.size() > 1 || values.has(quantity))
        all.push_back(quantity);
    for (const std::string &probe : goals.probes_as_goals)
      for (const NamedQuantity &quantity : values.largest_at(probe))
        all.push_back(quantity);
    if (goals.modes_as_goals)
      for (const NamedQuantity &quantity : values.of_modes())
        all.push_back(quantity);
  }



  std::string
  RunGoals::singularity_reason(const NamedQuantity &quantity) const
  {
    for (const NamedQuantity &term : quantity.terms)
      if (std::string reason = singularity_reason(term); !reason.empty())
        return reason;
    if (quantity.of != NamedQuantity::ObjectKind::probe ||
        (quantity.kind() != 'e' && quantity.kind() != 's'))
      return "";
    const Scene &scene = run.model().scene();
    const auto   probe =
      std::find_if(scene.probes.begin(),
                   scene.probes.end(),
                   [&](const Probe &one) { return one.name == quantity.name; });
    if (probe->box.norm() > 0.)
      return "";
    return lamella::singularity_reason(probe->position,
                                       probe->body,
                                       run.model().structure().bodies(),
                                       scene.supports,
                                       scene.loads,
                                       scene.contacts);
  }



  double
  RunGoals::scale_of(const NamedQuantity &quantity) const
  {
    return values.scale_of(quantity, rules);
  }



  double
  RunGoals::rounding_of(const NamedQuantity &quantity) const
  {
    const State               &state       = run.results().last().state;
    const std::vector<double> &corrections = state.contact_corrections.empty() ?
                                               state.free_corrections :
                                               state.contact_corrections;
    // Newton's method for large rotations has no corrections.
    return corrections.empty() ?
             0. :
             values.largest_of_kind(quantity) * corrections.back();
  }



  GoalResult
  RunGoals::with_error_bar(const unsigned int number, const ErrorBar &bar) const
  {
    GoalResult result = without_error_bar(number);
    result.estimate   = bar.estimate;
    result.bar        = bar.bar;
    if (result.has_limit)
      {
        result.trusted = bar.trusted;
        result.why     = bar.why;
      }
    if (result.value == 0. && has_no_active_contact(run))
      {
        result.trusted = false;
        result.why     = "no contact is active in the last load step";
      }
    return result;
  }



  bool
  RunGoals::has_no_active_contact(const Simulation &run)
  {
    const auto &contacts = run.results().last().contacts;
    return !contacts.empty() &&
           std::all_of(contacts.begin(), contacts.end(), [](const auto &rows) {
             return std::none_of(rows.begin(), rows.end(), [](const auto &row) {
               return row.touches();
             });
           });
  }



  GoalResult
  RunGoals::without_error_bar(const unsigned int number) const
  {
    const std::vector<Tolerance> &tolerances =
      run.model().scene().goals.tolerances;
    const NamedQuantity &quantity = all[number];
    GoalResult           result;
    result.name  = quantity.label();
    result.value = values.value(quantity);
    result.unit  = quantity.unit(run.model().scene().units);
    result.scale = scale_of(quantity);
    if (const std::string reason = singularity_reason(quantity);
        !reason.empty())
      {
        result.has_limit = false;
        result.why       = reason + ". Ask for it at some distance from there";
      }
    if (!tolerances.empty())
      result.tolerance =
        tolerances.size() == 1 ? tolerances[0] : tolerances.at(number);
    return result;
  }
} // namespace lamella
