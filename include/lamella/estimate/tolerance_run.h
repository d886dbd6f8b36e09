// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_tolerance_run_h
#define lamella_estimate_tolerance_run_h

#include <lamella/estimate/other_models.h>
#include <lamella/estimate/passes.h>
#include <lamella/run/simulation.h>

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
   *   1. solves the model and makes the bars of its goals as any run has them
   *      (bars_of()),
   *   2. writes its results, so that an interrupted run leaves those of its
   *      last whole pass,
   *   3. ends the run if all goals are met, or enriches the model in each
   *      source of error that matters to those that are open (Passes), along
   *      the axis in the elements that matter (marked_elements()). The first
   *      model is the scene as it is said (SV, SV-6 or LE-3 with contacts, and
   *      graded axes where it does not say).
   *
   * It also ends when the next model would exceed a budget, cannot be solved,
   * or would help no goal; the result is then that of the last pass with its
   * bars, and a note says why.
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
    /// `scene`, built, which tells @p progress and may not exceed the budget.
    std::unique_ptr<Simulation>
    next_model(std::ostream &progress);
    /// Solves `scene` and makes its bars; the simulation and its goals.
    void
    make_pass();
    /// Throws NumericsError if a pass that is not the first has no bar at all,
    /// as no other model of it could be solved: the pass before says more.
    void
    require_some_bar(const std::vector<GoalResult> &goals) const;
    /// Throws NumericsError unless the loads of @p next sum to those of the
    /// last pass, to 1e-7 of their size.
    void
    check_loads(const Simulation &next) const;
    /// Makes `scene` one with less of what the goals want less of: along the
    /// axis the elements that matter are bisected (marked_elements()), and
    /// those that do not are merged (merged()). Own fields of sections stand in
    /// for many DoFs only where the goals can lose what they leave out
    /// (lost_by_stand_ins(), Passes::can_lose()).
    void
    refine();
    /// @p next with less of the sources that are to be refined.
    Scene
    with_less_of(Scene next, const PlanRules &plan_rules) const;
    /// Whether the budget of seconds is spent.
    bool
    is_late() const;
    /// The results of the last pass, and the table of all, into the folder
    /// @p directory, which a run that is interrupted says from then on.
    void
    write_pass(const std::string &directory);
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
    FieldRules rules;
    PassRules  pass_rules;
    /// Of each goal what fields that stand in have lost; empty where none do.
    std::vector<double> lost_by_fields;
    /// In what the next pass is better than the last one.
    Refined       refined;
    Passes        passes;
    dealii::Timer wall;
  };
} // namespace lamella

#endif
