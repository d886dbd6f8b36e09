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
  /// Constants of CoarserModelEstimate.
  struct CoarserModelRules
  {
    /// Least degree N of LE-N with bars: LE-1 does not bound the error of LE-2.
    unsigned int min_degree = 3;
    /// Least last change over the one before; it may be small by accident.
    double min_share_of_previous = 1. / 8.;
    /// Least error over the sum of |contributions| of nodes, which may cancel.
    double min_share_of_sizes = 1. / 4.;
  };

  /**
   * Error bars of a run's goals from models that are poorer than the run.
   *
   * Goals with a derivative in scenes without contacts: the surpluses of the
   * run's highest functions (Surpluses) approximate the change from a poorer
   * model; two levels of section and axis give the bar (coarser_model_bar(),
   * CoarserModelRules).
   *
   * All others: the goals J_1 on half of the elements with one degree less and
   * J_2 on a quarter with two less. With J_0 of the run and the surpluses s of
   * goals that have any,
   *   d = max(|s_section| + |s_axis|, |J_0 - J_1|)
   * and e likewise for the levels before; the error is at least |J_1 - J_2| /
   * 8. Each model has its own gap rows and active set, so errors of the run's
   * active set are included. ContactShares adds penalties and load steps.
   */
  class CoarserModelEstimate
  {
  public:
    /// Returns why @p run has no such bars; empty if it has.
    static std::string
    unavailable_reason(const Simulation &run);

    /// Solves poorer models if goals need them. The last step of @p run has to
    /// be solved. Prints a line per model to @p out; @p cache keeps the models.
    /// Throws what Simulation throws. Collective.
    CoarserModelEstimate(const Simulation &run,
                         std::ostream     &out,
                         ModelCache       &cache);

    /// Returns the goals of the scene with their bars.
    std::vector<GoalResult>
    goals() const;

  private:
    /// Returns whether the goal @p number is compared with poorer models.
    bool
    needs_coarser_models(const unsigned int number) const;
    void
    solve_coarser_models(std::ostream &out, ModelCache &cache);
    /// Returns the bar by surpluses alone.
    ErrorBar
    by_surpluses(const NamedQuantity &goal, const SurplusParts &own) const;
    /// Returns the bar by poorer models, and by the surpluses @p own if given.
    ErrorBar
    by_models(const NamedQuantity               &goal,
              const std::optional<SurplusParts> &own) const;
    using Shares = std::vector<std::pair<std::string, double>>;
    /// Returns the part of each source in @p bar, signed by its last change.
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
    /// Numbers on half and on a quarter of the elements.
    std::optional<ResultNumbers> half, quarter;
  };
} // namespace lamella

#endif
