// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `run`: one scene from its description to its results. It owns the
// driver, Simulation, with the main loop, and the command line. All mechanics
// is in the other rooms. Where to start reading: Simulation::solve_as_built()
// in source/run/simulation.cc is the whole program on a page. It builds a scene
// (BuiltScene), and a path of load steps (LoadPath) is solved and recorded
// (StepRecorder). run_scene() writes them.

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

  /// The main loop from a scene to its results: for each load factor a Step
  /// from the previous state, and its results: fields at probes, lines and
  /// cuts, and reserve factors of plies. Then the search for first failure, if
  /// requested. Owns all that is built of the scene, and the results. On
  /// several processes each holds all of it and calls the same functions; all
  /// but the root process pass a stream without output.
  class Simulation
  {
  public:
    /// Builds the scene (BuiltScene); throws InputError for all its errors. No
    /// stiffness is assembled. Progress goes to @p out. What it needs of @p
    /// given is copied. @p rules choose the fields of SV-N. Collective.
    Simulation(const Scene      &given,
               std::ostream     &out,
               const FieldRules &rules = FieldRules());
    ~Simulation();

    /// Callback for the results after each step; its exceptions end the run.
    using Observer = std::function<void(const Results &)>;

    /**
     * Solves all load steps that are not solved yet, and returns results().
     * Throws InputError if the memory does not suffice, NumericsError for a
     * step that cannot be solved reliably, or with a too short search distance;
     * results() then has the steps before it. If a stiffness is ill-conditioned
     * before the first step, bodies with fields of their own get all fields of
     * their sections, once. If contact points miss a penetrating body, an
     * automatic axis gets shorter elements there, and all steps are repeated.
     * With an @p observer, state and tables of a step are dropped after the
     * next one. Collective.
     */
    const Results &
    solve(const Observer &observer = {});

    /// Takes @p steps of an earlier run as done, before solve(). The last of
    /// them has its state and warnings.
    void
    resume(std::vector<StepResults> steps);

    /// Returns the results so far; before solve() names, notes and loads only.
    const Results &
    results() const
    {
      return found;
    }

    /// Adds the goals of the last step with errors, or why there are none.
    void
    set_goals(std::vector<GoalResult> goals,
              const std::string      &missing_reason = "");

    /// Adds a note on the scene as a whole, a sentence without a full stop.
    void
    add_endnote(const std::string &note)
    {
      found.endnotes.push_back(note);
    }

    /// Frees the memory of solvers; only results() may be called afterwards.
    void
    release_solver();

    /// Stores seconds, memory and solver statistics so far in the results.
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
    /// scene, so that its load steps cannot be resumed.
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
    /// Rebuilds the scene with all fields of the section for bodies with fields
    /// of their own. Returns false, without any change, if there are none.
    bool
    rebuild_with_all_fields();
    /// Rebuilds the scene with shorter elements where contact points @p missed
    /// a body. Returns false, without any change, for a prescribed axis.
    bool
    shorten_elements(const UndetectedPenetration &missed);

    /// Prints @p what was changed and rebuilds all for the scene @p changed.
    void
    revise(Scene changed, const std::string &what);
    /// Rebuilds the scene with contact constraints at nodes of the ends that @p
    /// missing names. Returns false, without any change, for steps of an
    /// earlier run and if an end faces nothing.
    bool
    add_ends(const MissingEnds &missing);

    /// Solves the load steps with the fields that are built.
    const Results &
    solve_as_built(const Observer &observer);
    /// Checks the memory, factorizes, and creates the load step.
    void
    prepare();
    /// Returns the load step of linear kinematics, and makes its solver.
    std::unique_ptr<Step>
    make_linear_step(const MemoryBudget &budget);
    /// Returns the load step of large rotations, which makes its own solvers.
    std::unique_ptr<Step>
    make_large_step(const MemoryBudget &budget);
    /// Numbers the contact constraints again after a new pairing.
    void
    renumber_rows();
    void
    make_solver(const MemoryBudget &budget);
    /// Returns the stiffness with solvers; prints the sizes of factors.
    std::shared_ptr<const TangentOperator>
    linearize(const MemoryBudget &budget);
    /// Returns the state of heated bodies at load factor zero, whose stresses
    /// do not grow with loads; null if unused.
    std::shared_ptr<const BlockVector>
    solve_thermal_state(Step &step);
    /// Computes checks and contact results of an earlier run's last state.
    void
    complete_last_step();
    /// Solves the load steps that are left.
    void
    do_steps(const Observer &observer);
    /// Solves the next load step and appends its results.
    void
    do_step(const Observer &observer);
    /// Searches the load at which the smallest reserve factor is 1
    /// (FirstFailureSearch). Adds an endnote if nothing fails or solutions end.
    void
    find_first_failure();

    std::ostream &out;
    /// Wall seconds of each Phase, and of the object's lifetime.
    dealii::TimerOutput timer;
    dealii::Timer       wall;

    /// Each refers to those above; those below `built` are null before
    /// prepare(), and `solver` with finite rotations.
    std::unique_ptr<BuiltScene>    built;
    std::unique_ptr<ContactSolver> solver;
    std::unique_ptr<StepRecorder>  recorder;
    std::unique_ptr<LoadPath>      path;

    Results found;
    /// Flag of each body with an automatic axis, or that of another model.
    std::vector<bool> may_refine;
    /// True if the last step comes from an earlier run and has its state only.
    bool last_has_state_only = false;
    bool revised             = false;
  };
} // namespace lamella

#endif
