// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `run`: one scene from its description to its results. It owns the
// driver, Simulation, in which the main loop is, and the command line. All work
// is done by the rooms below, in the order that stands here; the driver never
// does mechanics of its own.
//
// Where to start reading: Simulation::solve_as_built() and what it calls, in
// source/run/simulation.cc, is the whole program in a page: a scene that is
// built (BuiltScene), what solves it, a path of load steps (LoadPath), each of
// them made results of (StepRecorder). run_scene() writes them into a folder.

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

  /**
   * The main loop: from a scene to its results. For each load factor in turn a
   * Step, from the state of the one before, and what it came to: fields at
   * probes, lines and cuts, the reserve factors of plies. Then first failure,
   * where the scene asks for it.
   *
   * Owns all that is built of the scene, and the results. On several processes
   * each builds and holds all of it and calls the same functions; who does not
   * speak for all hands in a stream that goes nowhere.
   */
  class Simulation
  {
  public:
    /// Builds everything that a scene can be wrong in (BuiltScene). Throws
    /// InputError; nothing is written. Progress goes to @p out, which is
    /// referred to. What it needs of @p given is copied. No stiffness matrix of
    /// a body is assembled yet. Fields of SV-N are chosen by @p rules.
    /// Collective.
    Simulation(const Scene      &given,
               std::ostream     &out,
               const FieldRules &rules = FieldRules());
    ~Simulation();

    /// Is handed the results each time that a load step is added to them; what
    /// it throws ends the run.
    using Observer = std::function<void(const Results &)>;

    /**
     * Solves all load steps that are not solved yet, and returns results().
     * Throws InputError if the memory does not suffice, NumericsError for a
     * step that cannot be solved or is not to be trusted, or in which a search
     * distance turns out too short; results() then has the steps before it.
     * Where a stiffness has lost its digits before the first step, bodies with
     * fields of their own get all fields of their sections, once. If contact
     * points miss a penetrating body, an automatic axis gets shorter elements
     * there, and all steps are repeated. With an @p observer the state and the
     * tables of a step are dropped when the next one is there: what it has not
     * taken is gone. Without one all steps stay whole. Collective.
     */
    const Results &
    solve(const Observer &observer = {});

    /// Takes @p steps of an earlier run of the scene as done, before solve().
    /// Of the last of them there are the state and what was said of it.
    void
    resume(std::vector<StepResults> steps);

    /// Returns the results so far; before solve() names, notes and loads only.
    const Results &
    results() const
    {
      return found;
    }

    /// Adds the goals of the last step with their errors, or why there are
    /// none.
    void
    set_goals(std::vector<GoalResult> goals,
              const std::string      &missing_reason = "");

    /// Adds a note on the scene as a whole, a sentence without a full stop.
    void
    add_endnote(const std::string &note)
    {
      found.endnotes.push_back(note);
    }

    /// Gives back the memory of what solves: results() is all that is left to
    /// ask for.
    void
    release_solver();

    /// Seconds, memory and solvers so far, into the results.
    void
    record_costs();

    /// Returns the scene's model, which solve() may build anew.
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

    /// Returns whether the run has changed the axis or the contacts of its
    /// scene, so that no other run can resume its load steps.
    bool
    is_revised() const
    {
      return revised;
    }

    /// Returns the stream for progress.
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
    /// Builds all anew with all fields of the section for bodies that had fewer
    /// of its own. False, and nothing is done, where there are none.
    bool
    rebuild_with_all_fields();
    /// Rebuilds the scene with shorter elements where contact points @p missed
    /// a penetrating body. Returns false, without any change, if the user
    /// prescribed the axis.
    bool
    shorten_elements(const UndetectedPenetration &missed);

    /// Prints @p what was changed and rebuilds all for the scene @p changed.
    void
    revise(Scene changed, const std::string &what);
    /// Rebuilds the scene with contact constraints at nodes of the ends that
    /// @p missing names: faces lose what slides over an end, and the mean gap
    /// over an element lets an end sink in. Returns false, without any change,
    /// for steps of an earlier run and if an end faces nothing.
    bool
    add_ends(const MissingEnds &missing);

    /// solve() of the fields that are built.
    const Results &
    solve_as_built(const Observer &observer);
    /// Looks whether the matrices fit, assembles and factorizes, and makes what
    /// does load steps.
    void
    prepare();
    /// Returns the load step of linear kinematics, and makes its solver.
    std::unique_ptr<Step>
    make_linear_step(const MemoryBudget &budget);
    /// Returns the load step of large rotations, which makes its own solvers.
    std::unique_ptr<Step>
    make_large_step(const MemoryBudget &budget);
    /// Numbers the contact constraints again, after contacts of large rotations
    /// have been paired anew.
    void
    renumber_rows();
    void
    make_solver(const MemoryBudget &budget);
    /// Returns the stiffness with a solver for each body; prints the sizes of
    /// factors.
    std::shared_ptr<const TangentOperator>
    linearize(const MemoryBudget &budget);
    /// Returns the state of heated bodies at load factor zero, whose stresses
    /// do not grow with loads; null if nothing needs it.
    std::shared_ptr<const BlockVector>
    solve_thermal_state(Step &step);
    /// Computes checks and contact results of the last step of an earlier run,
    /// of which only the state is known.
    void
    complete_last_step();
    /// Solves the load steps that are left.
    void
    do_steps(const Observer &observer);
    /// The next load step, and one more element of the results' steps.
    void
    do_step(const Observer &observer);
    /// The load at which the smallest reserve factor is 1 (FirstFailureSearch).
    /// Says in an endnote where nothing fails or states end.
    void
    find_first_failure();

    std::ostream &out;
    /// Wall seconds of each Phase, and of the object's whole life.
    dealii::TimerOutput timer;
    dealii::Timer       wall;

    /// Each refers to those above it; those below `built` are null before
    /// prepare(), and `solver` where bodies turn by any angle.
    std::unique_ptr<BuiltScene>    built;
    std::unique_ptr<ContactSolver> solver;
    std::unique_ptr<StepRecorder>  recorder;
    std::unique_ptr<LoadPath>      path;

    Results found;
    /// Marks bodies with an automatic axis, or that of a model beside a run or
    /// of a run to a tolerance.
    std::vector<bool> may_refine;
    /// True if the last step comes from an earlier run and has its state only.
    bool last_has_state_only = false;
    bool revised             = false;
  };
} // namespace lamella

#endif
