// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_goal_bars_h
#define lamella_estimate_goal_bars_h

#include <lamella/estimate/other_models.h>
#include <lamella/run/simulation.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace lamella
{
  /// The goals of a run with their bars, or why there are none: a sentence
  /// without a full stop.
  struct GoalBars
  {
    std::vector<GoalResult> goals;
    std::string             why_none;
  };

  /**
   * The bars of @p run, whose last step is solved, as the scene wants them
   * (ErrorBars): from what the run has (BarsFromBelow) where it has enough,
   *   auto    with goals that have no derivative left without,
   *   true    if all goals have one;
   * else, and where they are to be `richer`, from richer models (Estimation).
   * Bars at large rotations cover the axis alone (BarsFromHalf).
   * Where goals have tolerances they are made whatever they cost. @p out is
   * told of it, a line a model, which @p cache keeps. Collective.
   */
  GoalBars
  bars_of(const Simulation &run, std::ostream &out, ModelCache &cache);
} // namespace lamella

#endif
