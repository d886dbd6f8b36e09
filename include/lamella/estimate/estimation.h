// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `estimate`: errors of a run's numbers. It owns the surpluses of a
// run, the models that it is compared with, the error bars made of them, and
// the loop that refines to a tolerance. Simulation solves its other models, and
// duals (goal_dual.h) use the run's solver.

#ifndef lamella_estimate_estimation_h
#define lamella_estimate_estimation_h

#include <lamella/estimate/comparison_models.h>
#include <lamella/estimate/enrichment.h>
#include <lamella/estimate/error_bar.h>
#include <lamella/estimate/run_goals.h>
#include <lamella/recover/named_quantity.h>
#include <lamella/run/simulation.h>

#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Thresholds of Estimation.
  struct EstimationRules
  {
    /// Least share of a tolerance with which a source matters, and without
    /// tolerances of the sum of all shares.
    double min_tolerance_share = 0.1, min_total_share = 0.02;
  };

  /**
   * Error bars of a run's goals from richer models of the same scene:
   *   M_0          the run
   *   M_1 .. M_k   each with less of one source of error of the scene than a
   *                model M_j before it: axis, fields, section, contact
   *   M_r          axis, fields and section enriched once more.
   * The share of a source is J(M_i) - J(M_j). With J_1 = J(M_0) + sum of shares
   * the bar is error_bar() of J(M_0), J_1 and J_1 + J(M_r) - J(M_j). M_j is the
   * model just before, so that the shares sum to J(M_k) - J(M_0). With
   * tolerances it is the last one whose share is at least a tenth of a
   * tolerance for some goal, and M_r enriches only such sources, or the one
   * with the largest share.
   *
   * Each model has its own gap rows and active set, so errors of the run's
   * active set are included and quantities may be nonlinear. Localization gives
   * the share of the axis by elements for goals with a derivative. Collective.
   */
  class Estimation
  {
  public:
    /// Refers to @p run, whose last step is solved, @p cache, and @p out, which
    /// gets a line per model.
    Estimation(const Simulation &run, std::ostream &out, ModelCache &cache);

    /// Returns the goals with their bars, or with the reason if a richer model
    /// cannot be solved. Empty if ErrorBars::automatic bars cost too much.
    std::vector<GoalResult>
    goals();

    /// Returns why goals() is empty; empty if there are goals.
    std::string
    unavailable_reason() const;

  private:
    /// Returns the run as the first model.
    Model
    first_model() const;
    /// Model with less of one source than another one, by their numbers.
    struct Step
    {
      Source       source;
      unsigned int from = 0, to = 0;
    };

    /// Solves M_1 .. M_k and M_r.
    void
    solve_hierarchy();
    /// Solves M_r: M_j, or the model after the only source that matters, with
    /// less of significant_sources().
    void
    solve_richest_model();
    void
    add_step(const Source source);
    /// Returns the sources that M_r enriches: those of weight 1 or more, or the
    /// heaviest one; never contact.
    std::vector<Source>
    significant_sources() const;
    /// Returns the largest share of @p step in a goal over its threshold: a
    /// tenth of the tolerance, or a fiftieth of the sum of all shares.
    double
    weight_of(const Step &step) const;
    /// Returns the change of the goal @p quantity by @p step.
    double
    share_of(const Step &step, const NamedQuantity &quantity) const;
    /// Returns the result of the first refinement of @p quantity.
    Refinements
    first_refinement(const NamedQuantity &quantity) const;
    ErrorBar
    error_bar_of(const NamedQuantity &quantity) const;
    /// Returns the goal @p number, @p quantity, from all models.
    GoalResult
    goal(const NamedQuantity &quantity, const unsigned int number) const;

    const EstimationRules rules;
    const Simulation     &run;
    std::ostream         &out;
    ModelCache           &cache;
    ComparisonModels      others;
    /// Goals of the run; set by goals().
    std::unique_ptr<const RunGoals> of_run;
    /// Models, the run first, and M_r last if it was made.
    std::vector<Model> models;
    std::vector<Step>  steps;
    /// Numbers of the models that the next one, and M_r, are made of.
    unsigned int base = 0, before_richest = 0;
    /// Local errors of each of quantities(); empty if unknown.
    std::vector<std::optional<LocalErrors>> local;
    /// Reason why there is no richer model; empty if there is.
    std::string failure;
  };
} // namespace lamella

#endif
