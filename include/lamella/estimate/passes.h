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
  /// Parameters of a run to a tolerance.
  struct PassRules
  {
    /// Sources of error are refined, largest first, until the error by the
    /// remaining sources is below this fraction of the goal's tolerance.
    double max_unrefined_share = 0.5;
    /// A goal is not refined any further after `patience` passes without a bar
    /// in which it changes by more than its tolerance, or after `slow_passes`
    /// passes in which its bar did not decrease to `min_progress` of itself.
    unsigned int patience = 2, slow_passes = 3;
    double       min_progress = 0.5;
    /// Largest ratio of section errors from one degree to the next for which
    /// the degree is raised again; above it, a corner limits convergence.
    double max_degree_ratio = 0.5;
    /// Largest number of refinement passes.
    unsigned int max_passes = 8;
    /// Bisection leaves at most the first fraction of a tolerance to other
    /// elements; merging adds at most the second. Bisected elements have at
    /// least the third fraction of the total error.
    double max_remaining_share = 0.25, max_merged_share = 0.05,
           min_bisected_share = 0.65;
    /// Largest relative difference between the total loads of two passes.
    double loads_agree = 1e-7;
  };

  /// A refinement pass: one model with its theories, cost and error bars.
  struct Pass
  {
    unsigned int            dofs    = 0;
    double                  seconds = 0.;
    std::string             theories;
    std::vector<GoalResult> goals;
  };

  /// Refinement of a pass relative to the previous pass.
  struct PassRefinement
  {
    std::vector<Source> sources;
    /// Bisected elements if the axis is refined; if empty, all elements.
    std::optional<std::vector<ElementError>> marked = {};
  };

  /// Results of a goal in two previous passes, and the last two refinements.
  struct PassHistory
  {
    const GoalResult     &first, &before;
    const PassRefinement &then, &now;
  };

  /// Shortens the error bar of @p goal by its changes d_1 and d in the last two
  /// passes, if both refined the same sources R and all bars are trusted. Let b
  /// be the sum of the absolute bar contributions of R before the last pass,
  /// and q the larger of d / b and d / d_1. If q <= 2/3, the contribution of R
  /// is reduced to
  ///   max(d, 2 d q / (1 - q), b / 8) + errors of elements not bisected.
  void
  shorten(GoalResult        &goal,
          const PassHistory &course,
          const BarRules    &rules = {});

  /// Raises the contribution of @p source to @p goal's bar to @p least, if
  /// smaller.
  void
  raise_share(GoalResult &goal, const Source source, const double least);

  /// The refinement passes of a run to a tolerance, and the choice of the next
  /// refinement. After the last pass a goal is
  /// - met: within its tolerance, and changed since the previous pass by no
  ///   more than the bar of that pass;
  /// - dropped: not refined any further (PassRules), as its value may have no
  ///   limit, for example at a point load;
  /// - open: neither met nor dropped. The next pass refines for open goals that
  ///   have a bar, or for all open goals if none has a bar.
  class Passes
  {
  public:
    explicit Passes(const PassRules &rules = {});

    /// Adds a pass; @p refined is its refinement, empty for the first pass.
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

    /// Returns the goals for which the next pass refines; may be empty.
    std::vector<GoalResult>
    open_goals() const;

    /// Returns the goals that have not been dropped.
    std::vector<GoalResult>
    active_goals() const;

    /// Returns a sentence for each goal that was dropped in the last pass.
    std::vector<std::string>
    dropped_goals() const;

    /// Returns the sources of error to refine for open_goals(): the largest
    /// source of each goal, and others down to the fraction
    /// PassRules::max_unrefined_share of its tolerance.
    std::vector<Source>
    wanted() const;

    /// Returns true if higher degrees do not converge: for one of open_goals()
    /// the ratio of section errors exceeds PassRules::max_degree_ratio.
    bool
    degrees_stall() const;

    /// Returns true if an additional error @p lost of each goal is at most
    /// PassRules::max_unrefined_share of the largest error of active_goals().
    bool
    is_loss_acceptable(const std::vector<double> &lost) const;

    /// Returns the largest change of a goal over its tolerance; 0 at first.
    double
    largest_change() const;

    /// Returns why no further pass should follow; empty if one should.
    std::string
    reason_to_stop() const;

  private:
    /// Returns the change of goal number @p number since the previous pass.
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
    /// Pass (from 1) in which each goal was dropped; 0 if it was not.
    std::vector<unsigned int> dropped_in_pass;
  };
} // namespace lamella

#endif
