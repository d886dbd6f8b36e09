// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/progress.h>
#include <lamella/base/text.h>
#include <lamella/estimate/bars_from_below.h>
#include <lamella/estimate/bars_from_half.h>
#include <lamella/estimate/estimation.h>
#include <lamella/estimate/goal_bars.h>
#include <lamella/estimate/operations.h>

#include <algorithm>
#include <optional>
#include <ostream>

namespace lamella
{
  namespace
  {
    /// How @p run is compared with models on less of its axis, if it can be;
    /// where nobody has asked for it, if that costs little.
    std::optional<HalfPlan>
    plan_of(const Simulation &run)
    {
      if (!BarsFromHalf::reason_for_none(run).empty())
        return {};
      if (run.model().scene().goals.bars != ErrorBars::automatic)
        return HalfPlan();
      const HalfRules rules;
      return BarsFromHalf::plan(run,
                                std::max(rules.most_of_run * operations(run),
                                         rules.free_operations));
    }



    /// The goals of @p run with bars that need no richer model on the whole
    /// axis; none if these are not wanted, are not to be had, cost too much or
    /// fail.
    std::optional<std::vector<GoalResult>>
    cheap_goals(const Simulation &run, std::ostream &out, ModelCache &cache)
    {
      const bool below = BarsFromBelow::reason_for_none(run).empty();
      if (run.model().scene().goals.bars == ErrorBars::richer ||
          !RunGoals::reason_for_none(run).empty())
        return {};
      const std::optional<HalfPlan> plan = below ? HalfPlan() : plan_of(run);
      if (!plan)
        return {};
      out << "Error bars, from "
          << (below ? "poorer models" : "models on coarser axes") << ":"
          << std::endl;
      std::optional<std::vector<GoalResult>> goals;
      // The run has its numbers: nothing beside it takes them away.
      const Progress::Part part(out, "error bars");
      const Outcome        outcome = outcome_of([&] {
        goals = below ? BarsFromBelow(run, out, cache).goals() :
                               BarsFromHalf(run, *plan, out, cache).goals();
      });
      if (outcome.status != 0)
        out << "  failed: " << trimmed(outcome.message) << std::endl;
      return goals;
    }
  } // namespace



  GoalBars
  bars_of(const Simulation &run, std::ostream &out)
  {
    ModelCache cache;
    if (const auto goals = cheap_goals(run, out, cache))
      return {*goals, ""};
    Estimation estimation(run, out, cache);
    return {estimation.goals(), estimation.reason_for_none()};
  }
} // namespace lamella
