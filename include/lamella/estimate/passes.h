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
  /// How a run to a tolerance goes on.
  struct PassRules
  {
    /// Sources stay as they are that together have less than this share of what
    /// a goal may be off by.
    double small_share = 0.5;
    /// A goal leaves that has had no bar in so many passes one after the other
    /// and still changes by more than its tolerance, or whose bar over
    /// tolerance has not got better by this factor in so many.
    unsigned int patience = 2, slow_passes = 3;
    double       least_progress = 0.5;
    /// What one degree more leaves of the section's share of a bar at most for
    /// degrees to go on: a corner holds them back else.
    double most_of_degree = 0.5;
    /// More are a sign that none would be enough.
    unsigned int most_passes = 8;
    /// Of a tolerance: what elements may do to a goal that stay as they are,
    /// and that become one; and what those that are bisected do at least of
    /// all.
    double most_left = 0.25, most_merged = 0.05, least_done = 0.65;
    /// Of their size: what loads may differ by from pass to pass.
    double loads_agree = 1e-7;
  };

  /// One model of a run to a tolerance, with its bars.
  struct Pass
  {
    unsigned int            dofs    = 0;
    double                  seconds = 0.;
    std::string             theories;
    std::vector<GoalResult> goals;
  };

  /// What a pass has less of than the one before.
  struct Refined
  {
    std::vector<Source> sources;
    /// Where the axis is among them: its elements that are bisected; all of
    /// them where this is empty.
    std::optional<std::vector<ElementError>> marked = {};
  };

  /// A goal in three passes, one after the other, and in what the last two were
  /// refined.
  struct Course
  {
    const GoalResult &first, &before;
    const Refined    &then, &now;
  };

  /**
   * The bar of @p goal by what the last two passes have changed it by, d_1 and
   * then d, if both were refined in the same sources R. With the bars P of the
   * sources before, b = sum of P over R, and q the larger of d / b and d / d_1,
   *   max(d, 2 d q / (1 - q), b / 8) + what elements do that were not bisected
   *                                  + own bars of other sources,
   * if that is shorter than its own and q at most 2/3: the bar that a pass has
   * looks at poorer models, this at the passes themselves.
   */
  void
  shorten(GoalResult &goal, const Course &course, const BarRules &rules = {});

  /// Makes what @p source has of the bar of @p goal @p least, if it is less.
  void
  hold_share(GoalResult &goal, const Source source, const double least);

  /**
   * The passes of a run to a tolerance, and what they say of the next one. Of
   * the goals of the last pass
   *   met     are those within their tolerances that have changed since the
   *           pass before by no more than its bar said;
   *   left    those that no pass is made for any more: a number that has no
   *           limit, at a point load, say, keeps growing, and would take all
   *           elements for itself (PassRules::patience, least_progress);
   *   open    all others. The next pass is for those that have a bar, or where
   *           none has one for all.
   */
  class Passes
  {
  public:
    explicit Passes(const PassRules &rules = {});

    /// @p refined says in what; nothing of the first one.
    void
    add(const Pass &pass, const Refined &refined = {});

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
    all_met() const;

    /// The goals that the next pass is for; none, if no goal is open.
    std::vector<GoalResult>
    next_goals() const;

    /// All goals but those that have left.
    std::vector<GoalResult>
    staying() const;

    /// Those that have left in the last pass, a sentence each.
    std::vector<std::string>
    farewells() const;

    /// The sources of error that next_goals() want less of: the largest of each
    /// goal, and others until the rest has half of its tolerance or less
    /// (PassRules::small_share).
    std::vector<Source>
    wanted() const;

    /// Whether degrees do not contract: of one of next_goals() the section has
    /// more left of its share, after a pass that was refined in it, than
    /// PassRules::most_of_degree.
    bool
    degrees_stall() const;

    /// Whether goals may have lost this much, @p lost of each, beside all
    /// other errors: at most PassRules::small_share of what those may be off by
    /// that have not left.
    bool
    can_lose(const std::vector<double> &lost) const;

    /// The plain mesh check: what the goals have changed by since the last
    /// pass, the largest over its tolerance; 0 in the first pass.
    double
    largest_change() const;

    /// Why the passes themselves say that none is to follow; empty if one is.
    std::string
    reason_to_stop() const;

  private:
    /// What the goal @p number has changed by since the last pass.
    double
    change(const unsigned int number) const;
    bool
    is_met(const unsigned int number) const;
    bool
    has_to_leave(const unsigned int number) const;

    PassRules         rules;
    std::vector<Pass> made;
    /// Of each pass.
    std::vector<Refined> refinements;
    /// Of each goal the pass in which it has left, from 1 on; 0 of others.
    std::vector<unsigned int> left_in;
  };
} // namespace lamella

#endif
