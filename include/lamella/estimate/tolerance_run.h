// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_tolerance_run_h
#define lamella_estimate_tolerance_run_h

#include <lamella/estimate/comparison_models.h>
#include <lamella/estimate/passes.h>
#include <lamella/run/simulation.h>

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * Run to a tolerance: solves successively refined models of one scene until
   * the bars of all goals are within their tolerances. A pass
   *   1. solves the model and makes the bars of its goals (error_bars_of());
   *   2. writes its results, so that an interrupted run leaves those of its
   *      last complete pass;
   *   3. ends the run if all goals are met, or refines the model in each source
   *      of error that matters for open goals (Passes), along the axis in the
   *      elements that matter (marked_elements()).
   * The first model is the scene as given (without a theory SV, with contacts
   * SV-6 or LE-3; without elements graded axes).
   *
   * The run also ends if the next model would exceed a budget, cannot be
   * solved, or would help no goal. The result is then that of the last pass
   * with its bars, and a note gives the reason.
   */
  class ToleranceRun
  {
  public:
    /// Refers to @p out.
    ToleranceRun(const Scene &said, std::ostream &out);

    /// Makes passes, writes the results into @p directory and returns true if
    /// all goals are met. Throws what run_scene() throws for the first model.
    bool
    run(const std::string &directory);

    /// Returns the results of the last pass with its goals, after run(). They
    /// live as long as this object.
    const Results &
    results() const
    {
      return simulation->results();
    }

  private:
    /// Stores the element ends that stay, from the first pass @p first.
    void
    store_element_ends(const Scene &first);
    /// Returns the built `scene`, with its messages to @p progress and within
    /// the budget.
    std::unique_ptr<Simulation>
    next_model(std::ostream &progress);
    /// Solves `scene` and makes its bars; sets the simulation and its goals.
    void
    make_pass();
    /// Throws NumericsError if a pass after the first has no bar at all since
    /// no other model could be solved: the results of the pass before are
    /// better then.
    void
    check_any_bar(const std::vector<GoalResult> &goals) const;
    /// Throws NumericsError unless the load sums of @p next agree with those of
    /// the last pass to 1e-7 of their size.
    void
    check_loads(const Simulation &next) const;
    /// Refines `scene` for the open goals: elements that matter are bisected
    /// (marked_elements()), others are merged (merged()). Sections' own fields
    /// replace large LE only if the error is acceptable (surrogate_error(),
    /// Passes::is_loss_acceptable()).
    void
    refine();
    /// Returns @p next refined in the selected sources.
    Scene
    refined_in_sources(Scene next, const PlanRules &plan_rules) const;
    /// Returns whether the budget of seconds is spent.
    bool
    is_time_exceeded() const;
    /// Writes the results of the last pass and the table of all passes into the
    /// folder @p directory; an interrupted run reports that folder from then
    /// on.
    void
    write_pass(const std::string &directory);
    /// Returns why no further pass is made; empty if one is.
    std::string
    reason_to_stop() const;
    void
    print_pass() const;
    /// Prints that the run has ended, with @p reason.
    void
    print_end(const std::string &reason) const;
    /// Returns passes.csv: a line for each pass and goal.
    std::string
    table() const;

    Scene scene;
    /// Flag of each body that begins with equal elements by default
    /// (initial_model()), and element ends that are not merged: for all other
    /// bodies those of the first pass.
    std::vector<bool>                starts_with_equal_elements;
    std::vector<std::vector<double>> kept;
    std::ostream                    &out;
    std::unique_ptr<Simulation>      simulation;
    ModelCache                       cache;
    /// Rules of all models, so that they share end fields.
    FieldRules rules;
    PassRules  pass_rules;
    /// Error of each goal by SV-N in place of LE; empty without such bodies.
    std::vector<double> surrogate_errors;
    /// Refinement of the next pass.
    PassRefinement refined;
    Passes         passes;
    dealii::Timer  wall;
  };
} // namespace lamella

#endif
