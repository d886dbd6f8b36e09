// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_bars_from_below_h
#define lamella_estimate_bars_from_below_h

#include <lamella/estimate/contact_shares.h>
#include <lamella/estimate/error_bar.h>
#include <lamella/estimate/goal_dual.h>
#include <lamella/estimate/other_models.h>
#include <lamella/estimate/run_goals.h>
#include <lamella/estimate/surpluses.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// What bars from below are made by.
  struct BelowRules
  {
    /// Of the section's expansion: LE-1 to LE-2 says nothing of LE-2.
    unsigned int least_degree = 3;
    /// Of the change before: what the last change is taken for where it is
    /// small by accident, as of odd and even degrees.
    double least_of_before = 1. / 8.;
    /// Of the sizes by nodes, which may cancel.
    double least_of_sizes = 1. / 4.;
  };

  /**
   * The errors of a run's goals from what is poorer than the run.
   *
   * Where no bodies may touch, of goals with a derivative: what the run's
   * highest functions do to a goal, seen through the dual on its own factor
   * (Surpluses), is about the change from the poorer model, and two such levels
   * of section and axis make a bar (error_bar_from_below(), BelowRules).
   *
   * Else from two poorer models, on half of the elements with one degree less
   * and on a quarter with two: with the run's J_0 and theirs, J_1 and J_2, and
   * the surpluses s of the goals that have any,
   *   d = max(|s_section| + |s_axis|, |J_0 - J_1|)
   * and e likewise of the levels before; d is at least |J_1 - J_2| / 8.
   * Each has gap rows of its own mesh and its own active set: what the run's
   * frozen one cannot see, that it is wrong, these see.
   *
   * What penalties and load steps change comes to them (ContactShares).
   */
  class BarsFromBelow
  {
  public:
    /// Why there are none of @p run: a sentence without a full stop; empty if
    /// there are.
    static std::string
    reason_for_none(const Simulation &run);

    /// @p run, whose last step is solved, is referred to. reason_for_none() has
    /// to be empty. @p out is told of poorer models, a line each, which
    /// @p cache keeps. Throws what Simulation throws. Collective, as is
    /// goals().
    BarsFromBelow(const Simulation &run, std::ostream &out, ModelCache &cache);

    /// The goals of the scene with their bars.
    std::vector<GoalResult>
    goals() const;

  private:
    /// Whether the goal @p number is compared with poorer models.
    bool
    wants_models_of(const unsigned int number) const;
    void
    solve_poorer_models(std::ostream &out, ModelCache &cache);
    /// The bar by surpluses alone.
    ErrorBar
    by_surpluses(const NamedQuantity &goal, const SurplusBySource &own) const;
    /// The bar by poorer models, and by surpluses where there are @p own.
    ErrorBar
    by_models(const NamedQuantity                  &goal,
              const std::optional<SurplusBySource> &own) const;
    using Shares = std::vector<std::pair<std::string, double>>;
    /// What each source has of @p bar, with the sign of its last change.
    Shares
    shares_of(const NamedQuantity                  &goal,
              const ErrorBar                       &bar,
              const std::optional<SurplusBySource> &own) const;
    GoalResult
    goal(const unsigned int number) const;

    const Simulation &run;
    BelowRules        rules;
    RunGoals          of_run;
    GoalDual          dual;
    ContactShares     of_contact;
    /// Of each goal, if it has one.
    std::vector<std::optional<GoalDual::Pair>> derivatives;
    /// Null where the run has none.
    std::unique_ptr<const Surpluses> surpluses;
    /// On half and a quarter of the elements.
    std::optional<ResultNumbers> half, quarter;
  };
} // namespace lamella

#endif
