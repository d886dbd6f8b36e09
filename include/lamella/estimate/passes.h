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
  /// A refinement pass of a run to a tolerance: one solved model.
  struct Pass
  {
    unsigned int dofs    = 0;  ///< Number of DoFs of the model.
    double       seconds = 0.; ///< Wall time since the start of the run [s].
    /// Multiplications to factorize the model (predicted_costs()).
    double                  operations = 0.;
    std::string             theories; ///< Theories of all bodies, for output.
    std::string             recipe;   ///< Recipe of the error bars (GoalBars).
    std::vector<GoalResult> goals;    ///< Goals with their error bars.
  };

  /// Refinement of the model of a pass relative to the previous pass.
  struct PassRefinement
  {
    std::vector<Source> sources; ///< Refined error sources (mesh, theory, ...).
    /// Bisected axis elements if the axis is refined; if empty, all elements.
    std::optional<std::vector<ElementError>> marked = {};
    /// True if section cells are divided in place of a higher degree.
    bool divides_cells = false;
  };

  /// Results of a goal in the two passes before the last, with refinements.
  struct PassHistory
  {
    const GoalResult &first,    ///< Result two passes before the last pass.
      &before;                  ///< Result in the pass before the last pass.
    const PassRefinement &then, ///< Refinement of the pass before the last.
      &now;                     ///< Refinement of the last pass.
  };

  /// Shortens the error bar of @p goal by comparison with previous refinement
  /// passes, if the last two passes refined the same error sources R and all
  /// bars are trusted. Let d_1 and d be the last two changes of the value, b
  /// the sum of the absolute bar contributions of R before the last pass, and q
  /// the larger of d / b and d / d_1. If q <= 2/3, the contribution of R is
  /// reduced to
  ///   max(d, 2 d q / (1 - q), b / 8) + errors of elements not bisected.
  void
  shorten(GoalResult          &goal,
          const PassHistory   &course,
          const EstimateRules &rules = {});

  /// Raises the contribution of @p source to the bar of @p goal to @p least.
  void
  raise_share(GoalResult &goal, const Source source, const double least);

  /// The refinement passes of a run to a tolerance, and the choice of the next
  /// refinement. After the last pass a goal is
  /// - met: its bar is within its tolerance, and its value changed since the
  ///   previous pass by at most the bar of the previous pass;
  /// - dropped: not refined any further (EstimateRules), since its value may
  ///   have no limit, for example at a point load, or its bar does not
  ///   decrease. The count begins anew with the first pass that divides section
  ///   cells;
  /// - open: neither met nor dropped. The next pass refines for open goals that
  ///   have a bar, or for all open goals if none has a bar.
  class Passes
  {
  public:
    /// Creates an empty record of refinement passes, to be judged by @p rules.
    explicit Passes(const EstimateRules &rules = {});

    /// Adds @p pass and its refinement @p refined, empty for the first pass.
    /// Shortens its error bars (shorten()) and drops divergent goals.
    void
    add(const Pass &pass, const PassRefinement &refined = {});

    /// Returns all passes in order.
    const std::vector<Pass> &
    all() const
    {
      return made;
    }

    /// Returns the last pass; there must be one.
    const Pass &
    last() const
    {
      return made.back();
    }

    /// Returns true if the last pass meets the tolerances of all goals.
    bool
    all_goals_met() const;

    /// Returns the open goals for which the next pass refines, if any.
    std::vector<GoalResult>
    open_goals() const;

    /// Returns a sentence for each goal that was dropped in the last pass.
    std::vector<std::string>
    dropped_goals() const;

    /// Returns the error sources (mesh, theory, ...) to refine for
    /// open_goals(): the largest source of each goal, and others until the sum
    /// of the rest is below EstimateRules::max_unrefined_share times its
    /// tolerance.
    std::vector<Source>
    wanted() const;

    /// Returns true if raising section degrees does not converge: the ratio of
    /// section errors of an open goal in two passes with bars by the same
    /// recipe exceeds EstimateRules::max_degree_ratio.
    bool
    degrees_stall() const;

    /// Returns true if the additional errors @p lost, one per goal, are at most
    /// the fraction EstimateRules::max_unrefined_share of the tolerances.
    bool
    is_loss_acceptable(const std::vector<double> &lost) const;

    /// Returns the predicted wall time [s] of the next pass, whose model is
    /// factorized in @p operations: that of the last pass times the ratio of
    /// operations, each at least EstimateRules::free_operations.
    double
    predicted_seconds(const double operations) const;

    /// Returns the largest ratio of the change of a goal since the previous
    /// pass to its tolerance; 0 after the first pass.
    double
    largest_change() const;

    /// Returns why no pass should follow, for the user; empty if one should.
    std::string
    reason_to_stop() const;

  private:
    /// Returns the |change| of the goal @p number since the previous pass.
    double
    change(const unsigned int number) const;
    bool
    is_met(const unsigned int number) const;
    bool
    must_be_dropped(const unsigned int number) const;
    /// Returns true if a goal without a bar changes about as much as in the
    /// pass before, as at a singularity.
    bool
    grows(const unsigned int number) const;

    EstimateRules               rules;
    std::vector<Pass>           made;
    std::vector<PassRefinement> refinements; ///< Refinement of each pass.
    /// Number of passes before the first that divides section cells, or 0.
    std::size_t before_division = 0;
    bool division_is_refused    = false; ///< True after may_divide() was false.
    /// Pass (from 1) in which each goal was dropped; 0 if it was not.
    std::vector<unsigned int> dropped_in_pass;
  };
} // namespace lamella

#endif
