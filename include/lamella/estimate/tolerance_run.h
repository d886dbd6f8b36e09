// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_tolerance_run_h
#define lamella_estimate_tolerance_run_h

#include <lamella/adapt/plan.h>
#include <lamella/estimate/comparison_models.h>
#include <lamella/estimate/passes.h>
#include <lamella/run/simulation.h>

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Run to a tolerance: solves successively refined models of a scene until
  /// the error bars of all goals are within their tolerances. Each pass
  /// - solves the model and computes the error bars of its goals
  ///   (error_bars_of());
  /// - writes its results, so that an interrupted run leaves the results of its
  ///   last complete pass;
  /// - ends the run if all goals are met. Otherwise it refines each error
  ///   source that is significant for open goals (Passes), along the axis in
  ///   selected elements (marked_elements()).
  ///
  /// The first model is the scene as given. If the scene gives no theory, it
  /// has SV, or with contacts SV-6 or LE-3; if no elements, graded axes. The
  /// run also ends if the next model would exceed a budget, cannot be solved,
  /// or would not improve any goal. The results are then those of the last pass
  /// with its bars, and a note gives the reason.
  class ToleranceRun
  {
  public:
    /// Creates a run of the scene @p said. Keeps a reference to @p out.
    ToleranceRun(const Scene         &said,
                 std::ostream        &out,
                 const EstimateRules &rules = {});

    /// Performs refinement passes, writes results into the folder @p directory.
    /// Returns true if all goals are met. Throws as run_scene().
    bool
    run(const std::string &directory);

    /// Returns the results of the last pass with its goals, after run().
    const Results &
    results() const
    {
      return simulation->results();
    }

  private:
    /// Returns the simulation of `scene`, with messages to @p progress.
    std::unique_ptr<Simulation>
    next_model(std::ostream &progress);
    /// Throws NumericsError if a pass with @p dofs DoFs, factorized in @p
    /// operations, exceeds a budget.
    void
    check_budgets(const double dofs, const double operations) const;
    /// Solves `scene` and computes the error bars of its goals.
    void
    make_pass();
    /// Throws NumericsError if a pass after the first has no error bar, since
    /// no comparison model could be solved.
    void
    check_any_bar(const std::vector<GoalResult> &goals) const;
    /// Throws NumericsError if the resultant loads of @p next have changed.
    void
    check_loads(const Simulation &next) const;
    /// Refines `scene` for the open goals: selected elements are bisected
    /// (marked_elements()). SV-N replaces large LE only if the error is
    /// acceptable (surrogate_error()).
    void
    refine();
    /// Returns @p next with the error sources of the next pass refined.
    Scene
    refined_in_sources(Scene next, const PlanRules &plan_rules) const;
    /// Checks budgets and generates the next model. Returns why there is none;
    /// empty if there is one.
    std::string
    prepare_next_pass();
    /// Writes the last results and the table of all passes into @p directory.
    void
    write_pass(const std::string &directory);
    void
    print_pass() const;
    /// Prints that the run has ended, with @p reason.
    void
    print_end(const std::string &reason) const;
    /// Returns the text of passes.csv, a line for each pass and goal.
    std::string
    table() const;

    Scene                       scene;
    std::ostream               &out;
    std::unique_ptr<Simulation> simulation;
    ModelCache                  cache;
    /// Parameters of section functions; all models share boundary-layer modes.
    FieldRules    field_rules;
    EstimateRules rules;
    /// Error of each goal if SV-N replaces LE; empty if it does not.
    std::vector<double> surrogate_errors;
    PassRefinement      refined; ///< Refinement of the next pass.
    Passes              passes;
    dealii::Timer       wall;
  };

  /// Returns the scene of the first model of a run to a tolerance. If the input
  /// file does not set the Theory and there are contacts, plan() chooses SV-6
  /// (section functions for 6 wave numbers) or, with a sentence in @p why if
  /// not null, another theory for each body. Contacts are found with a model of
  /// TE-1, which is not solved. Throws the exceptions of BuiltScene.
  Scene
  initial_model(Scene                     scene,
                std::vector<std::string> *why   = nullptr,
                const PlanRules          &rules = {});

  /// Replaces SV-N by LE-3 (PlanRules::first_degree) in @p scene, from which @p
  /// model was built, for each body with SV-N by default that has all section
  /// functions at all nodes. Returns true if there is such a body.
  bool
  start_with_layerwise(Scene            &scene,
                       const BuiltScene &model,
                       const PlanRules  &rules = {});

  /// Returns @p scene with LE of degree PlanRules::first_degree (3) or more.
  Scene
  with_min_degree(Scene scene, const PlanRules &rules = {});
} // namespace lamella

#endif
