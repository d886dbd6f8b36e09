// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_estimation_h
#define lamella_estimate_estimation_h

// The room `estimate`: errors of a run's numbers. It owns the surpluses of a
// run, the models that it is compared with, the error bars made of them, and
// the loop that refines to a tolerance. Simulation solves its other models,
// and duals (goal_dual.h) use the run's solver. It never factorizes a body
// itself.

#include <lamella/adapt/plan.h>
#include <lamella/estimate/comparison_models.h>
#include <lamella/estimate/enrichment.h>
#include <lamella/estimate/error_bar.h>
#include <lamella/recover/named_quantity.h>
#include <lamella/run/simulation.h>
#include <lamella/scene/scene.h>

#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Returns a lower bound of the number of multiplications for the Cholesky
  /// factorizations of @p run, the sum of z^2 / n for factors with n columns
  /// and z nonzeros. Returns 0 if there are none (`cg`, strategy `full`).
  double
  operations(const Simulation &run);

  /// Returns the estimated number of multiplications for error bars by finer
  /// models (Estimation), in which SV-10 replaces Lagrange expansions LE-N. It
  /// is the sum of
  /// - factorization: c m^3 per axis node with m section functions, c =
  ///   CostRules::of_block, and CostRules::axes times the nodes of the run;
  /// - proper orthogonal decomposition of the responses to harmonic loads;
  /// - solutions on short end segments for the boundary-layer modes.
  ///
  /// Returns infinity unless SV-10 can replace LE-N in all bodies.
  double
  operations_of_bars(const Simulation &run,
                     const PlanRules  &rules = {},
                     const CostRules  &cost  = {});

  /// Returns the estimated number of multiplications of two models on axes
  /// halved @p times, for bodies of @p sizes: @p rich, of LE-N, and one degree
  /// less.
  double
  operations_of_coarser_axes(const Scene                 &rich,
                             const std::vector<BodySize> &sizes,
                             const unsigned int           times);

  /// Error bars of the goals of a run from finer models of the same scene:
  ///   M_0          the run
  ///   M_1 .. M_k   each with one error source refined relative to a
  ///                previous model M_j: axis, fields, section, contact
  ///   M_r          axis, fields and section refined once more.
  /// The change of a goal J by an error source is J(M_i) - J(M_j). With J_1 =
  /// J(M_0) + sum of the changes, the bar is error_bar() of J(M_0), J_1 and J_1
  /// + J(M_r) - J(M_j). Without tolerances, M_j is the model before M_i. With
  /// tolerances, it is the last one that changed a goal by at least a tenth of
  /// its tolerance. M_r refines sources with significant changes.
  ///
  /// Each model has its own contact constraints and active set, so errors of
  /// the active set are included and quantities may be nonlinear. Localization
  /// divides the change by the axis among its elements. Collective.
  class Estimation
  {
  public:
    /// Keeps references to @p run, whose last load step must have been solved,
    /// to @p cache, and to @p out, to which a line per model is printed.
    Estimation(const Simulation    &run,
               std::ostream        &out,
               ModelCache          &cache,
               const EstimateRules &rules = {});

    /// Solves the finer models and returns the goals with their error bars, or
    /// with the reason if a model cannot be solved. Returns none if `auto` bars
    /// are too expensive.
    std::vector<GoalResult>
    goals();

    /// Returns why goals() is empty, for the user; empty if it is not.
    std::string
    unavailable_reason() const;

  private:
    struct Step
    {
      Source       source;   ///< Refined error source.
      unsigned int from = 0, ///< Index of the coarser model in `models`.
        to              = 0; ///< Index of the finer model in `models`.
    };

    /// Solves the finer models: one per error source, and the finest model.
    void
    solve_hierarchy();
    /// Solves the finest model, refined again in significant_sources().
    void
    solve_richest_model();
    void
    add_step(const Source source);
    /// Returns the error sources that the finest model refines: those with
    /// weight_of() >= 1, or else the largest; never contact.
    std::vector<Source>
    significant_sources() const;
    /// Returns the largest ratio |change| / threshold of a goal by @p step.
    double
    weight_of(const Step &step) const;
    /// Returns true if all models so far have the goal @p quantity.
    bool
    has_all(const NamedQuantity &quantity) const;
    /// Returns the signed change of the goal @p quantity by @p step; 0 if a
    /// model lacks it.
    double
    share_of(const Step &step, const NamedQuantity &quantity) const;
    /// Returns the values of @p quantity before and after all steps.
    Refinements
    first_refinement(const NamedQuantity &quantity) const;
    ErrorBar
    error_bar_of(const NamedQuantity &quantity) const;
    /// Returns @p quantity, the goal with index @p number, with its error bar.
    GoalResult
    goal(const NamedQuantity &quantity, const unsigned int number) const;

    const EstimateRules rules;
    const Simulation   &run;
    std::ostream       &out;
    ModelCache         &cache;
    ComparisonModels    others;
    /// Goals of the run; set by goals().
    std::unique_ptr<const RunGoals> of_run;
    /// Solved models: the run, one per refinement step, and last the finest.
    std::vector<Model> models;
    std::vector<Step>  steps;
    /// Models from which the next and the finest model are refined.
    unsigned int base = 0, before_richest = 0;
    /// Error of each goal per axis element; empty if unknown.
    std::vector<std::optional<LocalErrors>> local;
    /// Reason why there is no finer model; empty if there is one.
    std::string failure;
  };
} // namespace lamella

#endif
