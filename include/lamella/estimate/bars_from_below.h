// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_bars_from_below_h
#define lamella_estimate_bars_from_below_h

#include <lamella/estimate/error_bar.h>
#include <lamella/estimate/goal_dual.h>
#include <lamella/estimate/run_goals.h>
#include <lamella/estimate/surpluses.h>

#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// What bars from below are made by.
  struct BelowRules
  {
    /// Of the section's expansion: LE-1 to LE-2 says nothing of LE-2.
    unsigned int least_degree = 3;
    /// Of the change before: what the section's last change is taken for where
    /// it is small by accident, as of odd and even degrees.
    double least_of_before = 1. / 8.;
    /// Of the sizes by nodes, which may cancel.
    double least_of_sizes = 1. / 4.;
  };

  /**
   * The errors of a run's goals from what the run itself has: what its highest
   * functions do to a goal, seen through the dual on its own factor
   * (Surpluses), is about the change from the poorer model, and two such levels
   * make a bar (error_bar_from_below(), BelowRules). No other model is solved,
   * so whether the active set is right would not be seen: there are none where
   * bodies touch.
   */
  class BarsFromBelow
  {
  public:
    /// Why there are none of @p run: a sentence without a full stop; empty if
    /// there are.
    static std::string
    reason_for_none(const Simulation &run);

    /// @p run, whose last step is solved, is referred to. reason_for_none() has
    /// to be empty. Collective, as is goals().
    explicit BarsFromBelow(const Simulation &run);

    /// The goals of the scene with their bars; those that have no derivative
    /// say so and have none.
    std::vector<GoalResult>
    goals() const;

    /// Whether all goals have a derivative.
    bool
    is_complete() const;

  private:
    GoalResult
    goal(const unsigned int number, const Surpluses &surpluses) const;

    const Simulation &run;
    BelowRules        rules;
    RunGoals          of_run;
    GoalDual          dual;
    /// Of each goal, if it has one.
    std::vector<std::optional<GoalDual::Pair>> derivatives;
  };
} // namespace lamella

#endif
