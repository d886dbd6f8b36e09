// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_goal_bars_h
#define lamella_estimate_goal_bars_h

#include <lamella/estimate/comparison_models.h>
#include <lamella/run/simulation.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace lamella
{
  /// Goals of a run with their bars, or the reason why there are none.
  struct GoalBars
  {
    std::vector<GoalResult> goals;
    std::string             missing_reason;
  };

  /// Returns the bars of @p run, whose last step is solved, as the scene
  /// requests them (ErrorBars): by CoarserModelEstimate, EnrichmentEstimate or
  /// HalvedAxisEstimate, the first that is possible, or else, and for `richer`,
  /// by Estimation. The former are at least twice the change by
  /// support_refinement_changes(). Goals with tolerances have bars at any cost.
  /// Prints a line per model to @p out; @p cache keeps the models. Collective.
  GoalBars
  error_bars_of(const Simulation &run, std::ostream &out, ModelCache &cache);
} // namespace lamella

#endif
