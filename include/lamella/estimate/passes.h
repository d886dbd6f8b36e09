// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_passes_h
#define lamella_estimate_passes_h

#include <lamella/estimate/enrichment.h>
#include <lamella/estimate/error_bar.h>
#include <lamella/recover/goal_result.h>

#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Constants of a run to a tolerance.
  struct PassRules
  {
    /// Share of a goal's largest error left to sources that are not refined.
    double max_unrefined_share = 0.5;
    /// Bounds for dropping a goal: `patience` passes without a bar while it
    /// still changes by more than its tolerance, or `slow_passes` in which bar
    /// over tolerance did not fall by `min_progress`.
    unsigned int patience = 2, slow_passes = 3;
    double       min_progress = 0.5;
    /// Largest ratio of the section's shares from one degree to the next for
    /// raising it further; above, a corner limits convergence.
    double max_degree_ratio = 0.5;
    /// Largest number of passes; more indicate that none would suffice.
    unsigned int max_passes = 8;
    /// Shares of a tolerance for the errors of remaining and merged elements;
    /// least share of the total error for bisected ones.
    double max_remaining_share = 0.25, max_merged_share = 0.05,
           min_bisected_share = 0.65;
    /// Relative difference allowed between the loads of successive passes.
    double loads_agree = 1e-7;
  };

  /// A model of a run to a tolerance, with its bars.
  struct Pass
  {
    unsigned int            dofs    = 0;
    double                  seconds = 0.;
    std::string             theories;
    std::vector<GoalResult> goals;
  };

  /// Refinement of a pass relative to the one before.
  struct PassRefinement
  {
    std::vector<Source> sources;
    /// Bisected elements if the axis is refined; empty: all elements.
    std::optional<std::vector<ElementError>> marked = {};
  };

  /// Results of a goal in the two passes before, and last two refinements.
  struct PassHistory
  {
    const GoalResult     &first, &before;
    const PassRefinement &then, &now;
  };

  /// Shortens the bar of @p goal by the changes of the last two passes, d_1 and
  /// then d, if both refined the same sources R and all bars are trusted. With
  /// the shares P before the pass, b = sum of |P| over R, and q the larger of d
  /// / b and d / d_1, the part of R becomes, if that is less and q <= 2/3,
  ///   max(d, 2 d q / (1 - q), b / 8) + errors of elements not bisected.
  void
  shorten(GoalResult        &goal,
          const PassHistory &course,
          const BarRules    &rules = {});

  /// Raises the share of @p source in @p goal's bar to at least @p least.
  void
  raise_share(GoalResult &goal, const Source source, const double least);

  /**
   * Passes of a run to a tolerance, and the refinement that the next one needs.
   * Goals of the last pass are
   *   met      within their tolerance, and changed since the pass before by no
   *            more than the bar of that pass;
   *   dropped  not refined any further: a number without a limit, as at a point
   *            load, would take all elements (PassRules::patience);
   *   open     all others. The next pass is for those with a bar, or for all if
   *            none has one.
   */
  class Passes
  {
  public:
    explicit Passes(const PassRules &rules = {});

    /// Adds a pass; @p refined is its refinement, empty for the first one.
    void
    add(const Pass &pass, const PassRefinement &refined = {});

    const std::vector<Pass> &
    all() const
    {
      return made;
    }

    const Pass &
    last() const
    {
      return made.back();
    }

    bool
    all_goals_met() const;

    /// Returns the goals that the next pass is for; none if no goal is open.
    std::vector<GoalResult>
    open_goals() const;

    /// Returns the goals that have not been dropped.
    std::vector<GoalResult>
    active_goals() const;

    /// Returns a sentence for each goal that the last pass has dropped.
    std::vector<std::string>
    dropped_goals() const;

    /// Returns the sources of error to refine for open_goals(): the largest of
    /// each, others down to PassRules::max_unrefined_share of its tolerance.
    std::vector<Source>
    wanted() const;

    /// Returns whether raising degrees stalls: for one of open_goals() the
    /// ratio of section shares exceeds PassRules::max_degree_ratio.
    bool
    degrees_stall() const;

    /// Returns whether an additional error @p lost of each goal is at most
    /// PassRules::max_unrefined_share of the largest error of active_goals().
    bool
    is_loss_acceptable(const std::vector<double> &lost) const;

    /// Returns the largest change of a goal over its tolerance; 0 at first.
    double
    largest_change() const;

    /// Returns why no further pass is to follow; empty if one is.
    std::string
    reason_to_stop() const;

  private:
    /// Returns the change of the goal @p number since the last pass.
    double
    change(const unsigned int number) const;
    bool
    is_met(const unsigned int number) const;
    bool
    must_be_dropped(const unsigned int number) const;

    PassRules         rules;
    std::vector<Pass> made;
    /// Refinement of each pass.
    std::vector<PassRefinement> refinements;
    /// Pass, from 1 on, in which each goal was dropped; 0 if it was not.
    std::vector<unsigned int> dropped_in_pass;
  };
} // namespace lamella

#endif
