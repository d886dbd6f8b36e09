// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_coarser_model_estimate_h
#define lamella_estimate_coarser_model_estimate_h

#include <lamella/estimate/comparison_models.h>
#include <lamella/estimate/contact_shares.h>
#include <lamella/estimate/error_bar.h>
#include <lamella/estimate/goal_dual.h>
#include <lamella/estimate/run_goals.h>
#include <lamella/estimate/surpluses.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Parameters of CoarserModelEstimate.
  struct CoarserModelRules
  {
    /// Smallest degree of LE with bars; LE-1 does not bound the error of LE-2.
    unsigned int min_degree = 3;
    /// The last change counts as at least this fraction of the previous one.
    double min_share_of_previous = 1. / 8.;
    /// The error is at least this fraction of sum |contribution of node|.
    double min_share_of_sizes = 1. / 4.;
  };

  /// Error bars of the goals of a run from coarser models.
  ///
  /// Goals with a derivative, in scenes without contacts: Surpluses approximate
  /// the change from a coarser model, for two levels of the section and of the
  /// axis (coarser_model_bar(), CoarserModelRules).
  ///
  /// All other goals: the goal is J_0 in the run, J_1 on half of the elements
  /// with one degree less, and J_2 on a quarter with two degrees less. The last
  /// change is
  ///   d = max(|s_section| + |s_axis|, |J_0 - J_1|)
  /// with the surpluses s (zero for goals without), and the change before is e,
  /// the same for the two previous levels. The bar is coarser_model_bar() of d
  /// and e, the error at least |J_1 - J_2| / 8. Each model has its own contact
  /// constraints and active set, so errors of the run's active set are
  /// included. ContactShares adds penalties and load steps.
  class CoarserModelEstimate
  {
  public:
    /// Returns why this method is not possible for @p run; empty if it is.
    static std::string
    unavailable_reason(const Simulation &run);

    /// Solves coarser models if goals require them. The last step of @p run
    /// must have been solved. Prints a line per model to @p out; @p cache
    /// stores the models. Throws what Simulation throws. Collective.
    CoarserModelEstimate(const Simulation &run,
                         std::ostream     &out,
                         ModelCache       &cache);

    /// Returns the goals of the scene with their error bars.
    std::vector<GoalResult>
    goals() const;

  private:
    /// Returns true if goal number @p number requires coarser models.
    bool
    needs_coarser_models(const unsigned int number) const;
    void
    solve_coarser_models(std::ostream &out, ModelCache &cache);
    /// Returns the error bar of @p goal from its surpluses @p own.
    ErrorBar
    by_surpluses(const NamedQuantity &goal, const SurplusParts &own) const;
    /// Returns the bar of @p goal from coarser models and surpluses @p own.
    ErrorBar
    by_models(const NamedQuantity               &goal,
              const std::optional<SurplusParts> &own) const;
    using Shares = std::vector<std::pair<std::string, double>>;
    /// Returns the contributions of sources to @p bar, signed as changes.
    Shares
    shares_of(const NamedQuantity               &goal,
              const ErrorBar                    &bar,
              const std::optional<SurplusParts> &own) const;
    GoalResult
    goal(const unsigned int number) const;

    const Simulation &run;
    CoarserModelRules rules;
    RunGoals          of_run;
    GoalDual          dual;
    ContactShares     of_contact;
    /// Derivative of each goal that has one.
    std::vector<std::optional<GoalDual::Pair>> derivatives;
    /// Surpluses of the run; null if it has none.
    std::unique_ptr<const Surpluses> surpluses;
    /// Results on half and on a quarter of the elements.
    std::optional<ResultNumbers> half, quarter;
  };
} // namespace lamella

#endif
