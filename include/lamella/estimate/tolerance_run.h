// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_tolerance_run_h
#define lamella_estimate_tolerance_run_h

#include <lamella/estimate/estimation.h>

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * A tolerance instead of a mesh: models of one scene, each with less of the
   * errors that matter, until the bars of all goals are within their
   * tolerances. A pass
   *   1. solves the model and estimates its goals (Estimation),
   *   2. writes its results, so that an interrupted run leaves those of its
   *      last whole pass,
   *   3. ends the run if all goals are met, or enriches the model in each
   * source of error with more than a quarter of what a goal may be off by,
   * along the axis in the elements that matter (marked_elements()). The first
   * model is the scene as it is said (SV, SV-6 with contacts, and graded axes
   * where it does not say).
   *
   * It also ends when the next model would exceed a budget, cannot be solved,
   * or when the worst goal has got no better in two passes; the result is then
   * that of the last pass with its bars, and a note says why.
   */
  class ToleranceRun
  {
  public:
    /// @p out is referred to.
    ToleranceRun(const Scene &said, std::ostream &out);

    /// Makes passes and writes the results into @p directory. Throws as
    /// run_scene() does for the first model.
    void
    run(const std::string &directory);

    /// Those of the last pass, with its goals; only after run(). They live as
    /// long as this object.
    const Results &
    results() const
    {
      return simulation->results();
    }

  private:
    /// Says which ends of elements stay, from @p first, the first pass.
    void
    keep_ends(const Scene &first);
    /// One model with its bars.
    struct Pass
    {
      unsigned int            number = 0, dofs = 0;
      double                  seconds = 0.;
      std::string             theories;
      std::vector<GoalResult> goals;
    };

    /// Solves and estimates `scene`; the simulation and its goals.
    void
    make_pass();
    /// Throws NumericsError unless the loads of @p next sum to those of the
    /// last pass, to 1e-7 of their size.
    void
    check_loads(const Simulation &next) const;
    /// The plain mesh check: what the goals have changed by since the last
    /// pass, the largest over its tolerance; 0 in the first pass.
    double
    largest_change() const;
    /// The sources that the goals want less of.
    std::vector<Source>
    wanted() const;
    /// The present scene with less of these: along the axis the elements that
    /// matter are bisected (marked_elements()), and those that do not are
    /// merged (merged()).
    Scene
    next_scene() const;
    /// Whether the budget of seconds is spent.
    bool
    is_late() const;
    /// The results of the last pass, and the table of all, into the folder
    /// @p directory, which a run that is interrupted says from then on.
    void
    write_pass(const std::string &directory);
    /// Makes the bars of the last pass with both refinements, and writes them.
    void
    end_with_bars(const std::string &directory);
    /// Of the first goal that is not met and has no richer model to compare
    /// with: why; empty if all have one.
    std::string
    why_no_richer_model() const;
    /// Why no further pass is made; empty if one is.
    std::string
    reason_to_stop() const;
    void
    print_pass() const;
    /// That the run has ended, and for what @p reason.
    void
    print_end(const std::string &reason) const;
    /// passes.csv, a line for each pass and goal.
    std::string
    table() const;

    Scene scene;
    /// Of each body whether it begins with equal elements, of which nobody has
    /// said anything (start_of()), and the ends of elements that are not to be
    /// merged: those of the first pass of all others.
    std::vector<bool>                begins_equal;
    std::vector<std::vector<double>> kept;
    std::ostream                    &out;
    std::unique_ptr<Simulation>      simulation;
    ModelCache                       cache;
    /// Of all models, so that they share end fields.
    FieldRules        rules;
    std::vector<Pass> passes;
    dealii::Timer     wall;
  };

  /// Whether all of @p goals have bars within their tolerances.
  bool
  all_met(const std::vector<GoalResult> &goals);

  /// The largest of bar over tolerance; where there is no bar twice the
  /// estimate stands for it.
  double
  worst_ratio(const std::vector<GoalResult> &goals);
} // namespace lamella

#endif
