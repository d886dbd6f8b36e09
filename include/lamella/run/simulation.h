// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `run`: one scene from its description to its results. It owns the
// driver, Simulation, with the main loop, and the command line. The driver
// does not contain mechanics. Where to start reading:
// Simulation::solve_as_built() in source/run/simulation.cc is the whole
// program on a page. It builds a scene (BuiltScene), and a path of load
// steps (LoadPath) is solved and recorded (StepRecorder). run_scene() writes
// them.

#ifndef lamella_run_simulation_h
#define lamella_run_simulation_h

#include <lamella/run/built_scene.h>
#include <lamella/run/step_results.h>
#include <lamella/solve/contact_solver.h>
#include <lamella/solve/load_path.h>

#include <deal.II/base/timer.h>

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  class MemoryBudget;

  /// A run from a scene to its results. For each load factor, a Step is solved
  /// from the previous state, and its results are evaluated: fields at probes,
  /// lines and cuts, and reserve factors of plies. The search for first failure
  /// follows, if requested. Owns all objects built from the scene, and the
  /// results. All processes own all of these and call the same functions;
  /// processes except the root pass a stream without output.
  class Simulation
  {
  public:
    /// Builds the scene (BuiltScene); throws InputError for all its errors. No
    /// stiffness is assembled. Prints progress to @p out. @p given is copied.
    /// @p rules are parameters for the fields of SV-N. Collective.
    Simulation(const Scene      &given,
               std::ostream     &out,
               const FieldRules &rules = FieldRules());
    ~Simulation();

    /// Callback for the results after each step; an exception ends the run.
    using Observer = std::function<void(const Results &)>;

    /// Solves all remaining load steps and returns results(). Throws InputError
    /// if the memory is insufficient, and NumericsError for a step that cannot
    /// be solved reliably, or whose search distance is too short; results()
    /// then contains the previous steps. If a stiffness is ill-conditioned
    /// before the first step, bodies of SV-N get all fields of their sections,
    /// once. If a body penetrates between contact points, an `auto` axis gets
    /// shorter elements there, and all steps are repeated. With an @p observer,
    /// state and tables of a step are released after the next step. Collective.
    const Results &
    solve(const Observer &observer = {});

    /// Sets @p steps of an earlier run as completed; call it before solve().
    /// The last of them must contain its state and warnings.
    void
    resume(std::vector<StepResults> steps);

    /// Returns the results so far; before solve() names, notes, loads only.
    const Results &
    results() const
    {
      return found;
    }

    /// Sets the goals with error bars, or the reason why there are none.
    void
    set_goals(std::vector<GoalResult> goals,
              const std::string      &missing_reason = "");

    /// Adds a note on the whole run, a sentence without a full stop.
    void
    add_endnote(const std::string &note)
    {
      found.endnotes.push_back(note);
    }

    /// Frees the memory of solvers; only results() may be called afterwards.
    void
    release_solver();

    /// Stores times, memory and solver statistics up to now in the results.
    void
    record_costs();

    /// Returns the objects built from the scene, which solve() may replace.
    const BuiltScene &
    model() const
    {
      return *built;
    }

    /// Returns the contact solver of linear kinematics. Call solve() first.
    ContactSolver &
    contact_solver() const
    {
      return *solver;
    }

    /// Returns true if the run has changed the axis or the contacts of its
    /// scene, so that its load steps cannot be resumed.
    bool
    is_revised() const
    {
      return revised;
    }

    /// Returns the stream for progress messages.
    std::ostream &
    output() const
    {
      return out;
    }

  private:
    const Scene &
    scene() const
    {
      return built->scene();
    }

    void
    build(const Scene &given, const FieldRules &rules);
    /// Rebuilds the scene with all section fields for bodies of SV-N. Returns
    /// false, without effect, if there are none.
    bool
    rebuild_with_all_fields();
    /// Rebuilds the scene with shorter elements at the penetration @p missed
    /// between contact points. Returns false if the axis is not `auto`.
    bool
    shorten_elements(const UndetectedPenetration &missed);

    /// Prints the change @p what and rebuilds all for the scene @p changed.
    void
    revise(Scene changed, const std::string &what);
    /// Rebuilds the scene with contact constraints at the end nodes in @p
    /// missing. Returns false for a resumed run, or if an end faces no surface.
    bool
    add_ends(const MissingEnds &missing);

    /// Solves the load steps with the current model.
    const Results &
    solve_as_built(const Observer &observer);
    /// Checks the memory, factorizes, and creates the load step.
    void
    prepare();
    /// Creates the load step of linear kinematics and its solver.
    std::unique_ptr<Step>
    make_linear_step(const MemoryBudget &budget);
    /// Creates the load step of finite rotations, with its own solvers.
    std::unique_ptr<Step>
    make_large_step(const MemoryBudget &budget);
    /// Renumbers the contact constraints after a new pairing.
    void
    renumber_rows();
    void
    make_solver(const MemoryBudget &budget);
    /// Returns the tangent with solvers; prints the sizes of factors.
    std::shared_ptr<const TangentOperator>
    linearize(const MemoryBudget &budget);
    /// Returns the displacements of heated bodies at load factor zero, whose
    /// stresses do not increase with loads; null if not needed.
    std::shared_ptr<const BlockVector>
    solve_thermal_state(Step &step);
    /// Computes checks and contact results of the last state of an earlier run.
    void
    complete_last_step();
    /// Solves the remaining load steps.
    void
    do_steps(const Observer &observer);
    /// Solves the next load step and appends its results.
    void
    do_step(const Observer &observer);
    /// Searches the load factor at which the smallest reserve factor is 1
    /// (FirstFailureSearch). Adds a note if nothing fails.
    void
    find_first_failure();

    std::ostream &out;
    /// Wall-clock time of each Phase, and since construction.
    dealii::TimerOutput timer;
    dealii::Timer       wall;

    /// Each object refers to the previous ones. Objects after `built` are null
    /// before prepare(), and `solver` also with finite rotations.
    std::unique_ptr<BuiltScene>    built;
    std::unique_ptr<ContactSolver> solver;
    std::unique_ptr<StepRecorder>  recorder;
    std::unique_ptr<LoadPath>      path;

    Results found;
    /// True for `auto` axes, in comparison models and runs to a tolerance.
    std::vector<bool> may_refine;
    /// True if the last step is of an earlier run and has a state only.
    bool last_has_state_only = false;
    bool revised             = false;
  };
} // namespace lamella

#endif
