// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `estimate`: how far a run's numbers are off. It owns the surpluses
// of a run and the richer models that it is compared with, the bars made of
// them, and the loop that goes on until a tolerance is reached. It never makes
// a factorisation of a body nor solves a model itself: a richer model is a
// scene like any other, and Simulation solves it; duals (goal_dual.h) ask the
// solver that this leaves behind.

#ifndef lamella_estimate_estimation_h
#define lamella_estimate_estimation_h

#include <lamella/estimate/enrichment.h>
#include <lamella/estimate/error_bar.h>
#include <lamella/estimate/other_models.h>
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
  /// What of the steps of Estimation matters.
  struct EstimationRules
  {
    /// A source does that has this share of a tolerance for some goal; or this
    /// one of what all of them do, where there is none.
    double least_of_tolerance = 0.1, least_of_all = 0.02;
  };

  /**
   * The errors of a run's goals, from richer models of the same scene:
   *   M_0          the run
   *   M_1 .. M_k   one source of error less each than a model before it: axis,
   *                fields, section, contact, whichever the scene has
   *   M_r          axis, fields and section enriched once more.
   * The share of a source is the change of the goal from the model that M_i was
   * made of, J(M_i) - J(M_j), and with the estimate of the first refinement,
   * J_1 = J(M_0) + sum of shares, the bar is that of error_bar() with J_1 and
   * J_1 + J(M_r) - J(M_j). Each is made of the last one before it, so the
   * shares sum to J(M_k) - J(M_0); but where goals have tolerances of the last
   * one whose share is a tenth of a tolerance or more for some goal, and M_r
   * has less of the sources with such shares only, or of the one with the
   * largest: what does not matter costs little.
   *
   * Each model is solved whole, with contact rows of its own mesh and its own
   * active set: what a frozen active set cannot see, that it is wrong, this
   * sees, and quantities need not be linear in the displacements. Of quantities
   * that have a derivative the share of the axis is told element by element
   * (Localisation).
   *
   * Collective.
   */
  class Estimation
  {
  public:
    /// @p run, whose last step is solved, @p out and @p cache are referred to.
    /// @p out is told of each model, a line each.
    Estimation(const Simulation &run, std::ostream &out, ModelCache &cache);

    /// The goals of the scene with their bars. Where a richer model cannot be
    /// solved, the goals say why there is no bar. Empty without goals, or where
    /// ErrorBars::automatic would cost too much.
    std::vector<GoalResult>
    goals();

    /// Why goals() is empty: the scene wants no bars, or they cost too much. A
    /// sentence without a full stop; empty if there are goals.
    std::string
    reason_for_none() const;

  private:
    /// The run as the first model.
    Model
    first_model() const;
    /// One more model, with less of one source than another.
    struct Step
    {
      Source       source;
      unsigned int from = 0, to = 0;
    };

    /// M_1 .. M_k, and M_r.
    void
    climb();
    /// M_r: M_k, or the model after the one source that matters, with less of
    /// sources_that_matter() once more.
    void
    climb_once_more();
    void
    add_step(const Source source);
    /// The sources that M_r has less of: those with a weight of 1 or more, or
    /// the heaviest. Contact has one step only.
    std::vector<Source>
    sources_that_matter() const;
    /// The largest share of @p step in a goal, over what makes it matter: a
    /// tenth of the tolerance, or a fiftieth of what all steps do together.
    double
    weight_of(const Step &step) const;
    /// Of the goal @p quantity what the first refinement changes by @p step.
    double
    share_of(const Step &step, const NamedQuantity &quantity) const;
    /// What the first refinement makes of @p quantity.
    Refinements
    first_refinement(const NamedQuantity &quantity) const;
    ErrorBar
    bar_of(const NamedQuantity &quantity) const;
    /// What the models say of it.
    GoalResult
    goal(const NamedQuantity &quantity, const unsigned int number) const;

    const EstimationRules rules;
    const Simulation     &run;
    std::ostream         &out;
    ModelCache           &cache;
    OtherModels           others;
    /// From goals() on.
    std::unique_ptr<const RunGoals> of_run;
    /// The run first, and M_r last if it was made.
    std::vector<Model> models;
    std::vector<Step>  steps;
    /// The model that the next one is made of, and the one that M_r is.
    unsigned int base = 0, before_richest = 0;
    /// Of each of quantities(); empty where they are not known.
    std::vector<std::optional<LocalErrors>> local;
    /// Why there is no richer model; empty if there is.
    std::string failure;
  };
} // namespace lamella

#endif
