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
  /// Goals of a run with their error bars, or the reason why there are none.
  struct GoalBars
  {
    std::vector<GoalResult> goals; ///< Empty if there are no error bars.
    std::string             missing_reason; ///< Sentence; empty if bars exist.
  };

  /// Returns the goals of @p run, whose last load step must have been solved,
  /// with the error bars that the input file requests (ErrorBars), at any cost
  /// for goals with tolerances. The first available of CoarserModelEstimate,
  /// EnrichmentEstimate and HalvedAxisEstimate is used; if none is, or for
  /// `richer`, Estimation. Bars of the first three are at least twice
  /// support_refinement_changes(), the change by refinement at supports. Prints
  /// a line per model to @p out; @p cache stores the models. Collective.
  GoalBars
  error_bars_of(const Simulation &run, std::ostream &out, ModelCache &cache);
} // namespace lamella

#endif
