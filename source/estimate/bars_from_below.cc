// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/estimate/bars_from_below.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  std::string
  BarsFromBelow::reason_for_none(const Simulation &run)
  {
    if (!run.results().last().state.active.empty())
      return "bodies touch, and that the rows which are active are not the "
             "right ones shows on other meshes only";
    return Surpluses::reason_for_none(run, BelowRules().least_degree);
  }



  BarsFromBelow::BarsFromBelow(const Simulation &run)
    : run(run)
    , of_run(run)
    , dual(run)
  {
    for (const NamedQuantity &quantity : of_run.quantities())
      derivatives.push_back(dual.derivative(quantity));
  }



  bool
  BarsFromBelow::is_complete() const
  {
    return std::all_of(derivatives.begin(),
                       derivatives.end(),
                       [](const auto &one) { return one.has_value(); });
  }



  GoalResult
  BarsFromBelow::goal(const unsigned int number,
                      const Surpluses   &surpluses) const
  {
    const NamedQuantity &quantity   = of_run.quantities()[number];
    GoalResult           result     = of_run.bare(number);
    const auto          &derivative = derivatives[number];
    if (!derivative)
      {
        result.why = "it has no derivative to tell its error by; Error bars = "
                     "richer compares it with richer models";
        return result;
      }
    const auto [section, axis] = surpluses.of(dual.solve(*derivative).u);
    const ErrorBar bar         = error_bar_from_below(
      {{section.last,
                section.before,
                std::max(rules.least_of_before * std::abs(section.before),
                 rules.least_of_sizes * section.by_nodes)},
               {axis.last, axis.before, rules.least_of_sizes * axis.by_nodes}},
      result.scale,
      of_run.rounding_of(quantity));
    result.estimate = bar.estimate;
    result.bar      = bar.bar;
    result.trusted  = bar.trusted;
    result.why      = bar.why;
    result.shares   = {{"axis", axis.last}, {"section", section.last}};
    return result;
  }



  std::vector<GoalResult>
  BarsFromBelow::goals() const
  {
    const Surpluses         surpluses(run);
    std::vector<GoalResult> results;
    for (unsigned int k = 0; k < of_run.quantities().size(); ++k)
      results.push_back(goal(k, surpluses));
    return results;
  }
} // namespace lamella
