// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `estimate`: errors of a run's numbers. It owns the surpluses of a
// run, the models that it is compared with, the error bars made of them, and
// the loop that refines to a tolerance. Simulation solves its other models,
// and duals (goal_dual.h) use the run's solver. It never factorizes a body
// itself.

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
    /// The most accurate model refines a source of error if its change of a
    /// goal is at least this fraction of the tolerance or, without tolerances,
    /// of the sum of all changes.
    double min_tolerance_share = 0.1, min_total_share = 0.02;
  };

  /// Error bars of the goals of a run from finer models of the same scene:
  ///   M_0          the run
  ///   M_1 .. M_k   each with one source of error reduced relative to a
  ///                previous model M_j: axis, fields, section, contact
  ///   M_r       axis, fields and section refined once more.
  /// The change by a source is J(M_i) - J(M_j). With J_1 = J(M_0) + sum of the
  /// changes, the bar is error_bar() of J(M_0), J_1 and J_1 + J(M_r) - J(M_j).
  /// M_j is the previous model, so that the changes sum to J(M_k) - J(M_0).
  /// With tolerances, M_j is the last model that changed a goal by at least a
  /// tenth of its tolerance; M_r refines only such sources, or the largest.
  ///
  /// Each model has its own contact constraints and active set, so errors of
  /// the active set are included and quantities may be nonlinear. Localization
  /// divides the change by the axis among its elements. Collective.
  class Estimation
  {
  public:
    /// Keeps references to @p run, whose last step must have been solved, to
    /// @p cache, and to @p out, to which a line per model is printed.
    Estimation(const Simulation &run, std::ostream &out, ModelCache &cache);

    /// Returns the goals with their bars, or with the reason if a finer model
    /// cannot be solved. Empty if bars are `auto` and too expensive.
    std::vector<GoalResult>
    goals();

    /// Returns why goals() is empty; empty if it is not.
    std::string
    unavailable_reason() const;

  private:
    /// Returns the run as model M_0.
    Model
    first_model() const;
    /// A refinement by one source, with the numbers of the models in `models`.
    struct Step
    {
      Source       source;
      unsigned int from = 0, to = 0;
    };

    /// Solves the models M_1 .. M_k and M_r.
    void
    solve_hierarchy();
    /// Solves M_r: a model refined in significant_sources().
    void
    solve_richest_model();
    void
    add_step(const Source source);
    /// Returns the sources that M_r refines: those of weight 1 or more, or the
    /// one of largest weight; never contact.
    std::vector<Source>
    significant_sources() const;
    /// Returns the largest change of a goal by @p step over its threshold: a
    /// tenth of the tolerance, or a fiftieth of the sum of all changes.
    double
    weight_of(const Step &step) const;
    /// Returns the change of the goal @p quantity by @p step.
    double
    share_of(const Step &step, const NamedQuantity &quantity) const;
    /// Returns the values of the first refinement of @p quantity.
    Refinements
    first_refinement(const NamedQuantity &quantity) const;
    ErrorBar
    error_bar_of(const NamedQuantity &quantity) const;
    /// Returns the result of goal number @p number, @p quantity.
    GoalResult
    goal(const NamedQuantity &quantity, const unsigned int number) const;

    const EstimationRules rules;
    const Simulation     &run;
    std::ostream         &out;
    ModelCache           &cache;
    ComparisonModels      others;
    /// Goals of the run; set by goals().
    std::unique_ptr<const RunGoals> of_run;
    /// Models in order, the run first, and M_r last if it was solved.
    std::vector<Model> models;
    std::vector<Step>  steps;
    /// Numbers of the models from which the next model, and M_r, are refined.
    unsigned int base = 0, before_richest = 0;
    /// Local errors of each goal; empty if unknown.
    std::vector<std::optional<LocalErrors>> local;
    /// Reason why there is no finer model; empty if there is one.
    std::string failure;
  };
} // namespace lamella

#endif
