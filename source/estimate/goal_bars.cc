// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/estimate/bars_from_below.h>
#include <lamella/estimate/estimation.h>
#include <lamella/estimate/goal_bars.h>

#include <optional>
#include <ostream>

namespace lamella
{
  namespace
  {
    /// The goals of @p run with bars from below; none if these are not wanted,
    /// the run has not enough for them, or they fail.
    std::optional<std::vector<GoalResult>>
    goals_from_below(const Simulation &run, std::ostream &out)
    {
      const ErrorBars wanted = run.model().scene().goals.bars;
      if (wanted == ErrorBars::richer ||
          !RunGoals::reason_for_none(run).empty() ||
          !BarsFromBelow::reason_for_none(run).empty())
        return {};
      std::optional<std::vector<GoalResult>> goals;
      // The run has its numbers: nothing beside it takes them away.
      const Outcome outcome = outcome_of([&] {
        const BarsFromBelow below(run);
        if (wanted == ErrorBars::automatic || below.is_complete())
          goals = below.goals();
      });
      if (outcome.status != 0)
        out << "No error bars from the highest functions of the run: "
            << trimmed(outcome.message) << std::endl;
      else if (goals)
        out << "Error bars, from the highest functions of the run" << std::endl;
      return goals;
    }
  } // namespace



  GoalBars
  bars_of(const Simulation &run, std::ostream &out)
  {
    if (const auto goals = goals_from_below(run, out))
      return {*goals, ""};
    ModelCache cache;
    Estimation estimation(run, out, cache);
    return {estimation.goals(), estimation.reason_for_none()};
  }
} // namespace lamella
