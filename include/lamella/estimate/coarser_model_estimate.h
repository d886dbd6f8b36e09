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
  /// Parameters of error bars from coarser models.
  struct CoarserModelRules
  {
    /// Smallest section degree N of LE-N (Lagrange expansion) with error bars;
    /// the change from LE-1 to LE-2 does not bound the error of LE-2.
    unsigned int min_degree = 3;
    /// Lower limit of the error, as a fraction of the change of the goal from
    /// the second to the next coarser model (of lower degree).
    double min_share_of_previous = 1. / 8.;
    /// Lower limit of the error, as a fraction of Surplus::by_nodes: the sum of
    /// |contribution| of all nodes to the change from the coarser model.
    double min_share_of_sizes = 1. / 4.;
  };

  /// Error bars of the goals (output quantities) of a run from coarser models.
  ///
  /// If a goal J has a derivative and the scene has no contacts, its changes
  /// from two coarser sections and two coarser axes are approximated by
  /// Surpluses. coarser_model_bar() of these changes is the bar.
  ///
  /// All other goals: J_0 is the goal in the run, J_1 on half of the elements
  /// with one degree less, and J_2 on a quarter with two degrees less. The last
  /// change is
  ///   d = max(|s_section| + |s_axis|, |J_0 - J_1|)
  /// with the changes s by section and axis from Surpluses (zero if unknown).
  /// The same formula with J_1 - J_2 gives the previous change e. The bar is
  /// coarser_model_bar() of d and e, with an error of at least |J_1 - J_2| / 8.
  /// Each model has its own contact constraints and active set, so active-set
  /// errors are included. ContactShares adds penalties and load steps.
  class CoarserModelEstimate
  {
  public:
    /// Returns the reason why @p run cannot have such error bars, a sentence
    /// for the user; empty if it can.
    static std::string
    unavailable_reason(const Simulation &run);

    /// Solves coarser models if goals require them. The last load step of @p
    /// run must have been solved. Prints a line per model to @p out; @p cache
    /// stores the models. Throws as Simulation does. Collective.
    CoarserModelEstimate(const Simulation &run,
                         std::ostream     &out,
                         ModelCache       &cache);

    /// Returns the goals of the scene with their error bars.
    std::vector<GoalResult>
    goals() const;

  private:
    /// Returns true if the goal with index @p number requires coarser models.
    bool
    needs_coarser_models(const unsigned int number) const;
    void
    solve_coarser_models(std::ostream &out, ModelCache &cache);
    /// Returns the error bar of @p goal from its surpluses @p own alone.
    ErrorBar
    by_surpluses(const NamedQuantity &goal, const SurplusParts &own) const;
    /// Returns the error bar of @p goal from coarser models and surpluses.
    ErrorBar
    by_models(const NamedQuantity               &goal,
              const std::optional<SurplusParts> &own) const;
    using Shares = std::vector<std::pair<std::string, double>>;
    /// Returns names and signed contributions of error sources to @p bar.
    Shares
    shares_of(const NamedQuantity               &goal,
              const ErrorBar                    &bar,
              const std::optional<SurplusParts> &own) const;

    const Simulation &run;
    CoarserModelRules rules;
    RunGoals          of_run;
    GoalDual          dual;
    ContactShares     of_contact;
    /// Derivative of each goal; empty if it has none.
    std::vector<std::optional<GoalDual::Pair>> derivatives;
    /// Hierarchical surpluses of the run; null if it has none.
    std::unique_ptr<const Surpluses> surpluses;
    /// Results on half and a quarter of the elements; empty if not solved.
    std::optional<ResultNumbers> half, quarter;
  };
} // namespace lamella

#endif
