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

#include <lamella/recover/results.h>
#include <lamella/run/built_scene.h>
#include <lamella/run/step_results.h>
#include <lamella/solve/linear_system.h>
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

  /// Solves the load steps of a scene and evaluates their results: fields at
  /// probes, lines and cuts, and reserve factors of plies. Each load step
  /// starts from the state of the previous one. The search for first failure
  /// follows, if requested. Owns the model (BuiltScene) and the results. All
  /// processes call the same functions; processes except the root pass a stream
  /// without output.
  class Simulation
  {
  public:
    /// Builds the model of a copy of @p given, without stiffness matrices. @p
    /// rules control the choice of section functions for theory SV-N. Prints
    /// progress to @p out. Throws InputError for errors of the scene.
    /// Collective.
    Simulation(const Scene      &given,
               std::ostream     &out,
               const FieldRules &rules = FieldRules());
    ~Simulation();

    /// Callback with the results after each load step; exceptions end solve().
    using Observer = std::function<void(const Results &)>;

    /// Solves all remaining load steps and returns results(). Throws InputError
    /// if the memory is insufficient. Throws NumericsError if a step cannot be
    /// solved reliably, or if a contact search distance is too short; results()
    /// then contains the previous steps. If @p observer is given, calls it
    /// after each step, and frees the state of a step after the next one.
    /// Collective.
    ///
    /// If a body penetrates another one between contact points, all steps are
    /// repeated with shorter elements (of an `auto` axis); if its end does,
    /// with contact points at the end. If a stiffness is ill-conditioned before
    /// the first step, bodies of theory SV-N get all section functions.
    const Results &
    solve(const Observer &observer = {});

    /// Sets the load @p steps that an earlier run has completed; call it before
    /// solve(). The last of them must contain its state and warnings.
    void
    resume(std::vector<StepResults> steps);

    /// Returns the results so far; before solve(), only names, notes and loads.
    const Results &
    results() const
    {
      return found;
    }

    /// Sets the @p goals with their error bars, or the reason for no goals.
    void
    set_goals(std::vector<GoalResult> goals,
              const std::string      &missing_reason = "");

    /// Adds the sentence @p note, without a full stop, to the final notes.
    void
    add_endnote(const std::string &note)
    {
      found.endnotes.push_back(note);
    }

    /// Frees the memory of solvers. Afterwards only results() and model() may
    /// be called.
    void
    release_solver();

    /// Stores times, memory and solver statistics so far in the results.
    void
    record_costs();

    /// Returns the model built from the scene; solve() may replace it.
    const BuiltScene &
    model() const
    {
      return *built;
    }

    /// Returns the contact solver after solve() with linear kinematics.
    LinearSystem &
    linear_system() const
    {
      return *solver;
    }

    /// Returns true if solve() has changed the axis meshes or the contacts of
    /// the scene. The load steps of such a run cannot be resumed.
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
    /// Rebuilds the model with all section functions for bodies of theory SV-N.
    /// Returns false, without effect, if there are none.
    bool
    rebuild_with_all_fields();
    /// Rebuilds the model with shorter elements where bodies penetrate between
    /// contact points (@p missed). Returns false if the axis is not `auto`.
    bool
    shorten_elements(const UndetectedPenetration &missed);

    /// Rebuilds the model for the scene @p changed; prints the change @p what.
    void
    revise(Scene changed, const std::string &what);
    /// Rebuilds the model with contact constraints at the end nodes in @p
    /// missing. Returns false for a resumed run, or if an end faces no surface.
    bool
    add_ends(const MissingEnds &missing);

    /// Solves the load steps with the current model, without changes to it.
    const Results &
    solve_as_built(const Observer &observer);
    /// Checks the memory, factorizes, and creates the solver of load steps.
    void
    prepare();
    /// Creates the solvers of load steps and contact for linear kinematics.
    std::unique_ptr<NonlinearSolver>
    make_linear_solver(const MemoryBudget &budget);
    /// Creates the solver of load steps with finite rotations.
    std::unique_ptr<NonlinearSolver>
    make_large_solver(const MemoryBudget &budget);
    /// Copies the constraints of the last solution with finite rotations into
    /// the model.
    void
    update_interfaces();
    void
    make_solver(const MemoryBudget &budget);
    /// Returns the factorized stiffness at zero displacements.
    std::shared_ptr<const TangentOperator>
    linearize(const MemoryBudget &budget);
    /// Returns the displacements due to temperatures alone, as reserve factors
    /// multiply only the stresses due to loads; null if not needed.
    std::shared_ptr<const BlockVector>
    solve_thermal_state(LoadStep &step);
    /// Adds checks and contact results, not in restart data, to the last step.
    void
    complete_last_step();
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
    std::unique_ptr<BuiltScene>   built;
    std::unique_ptr<LinearSystem> solver;
    /// Strategy of `solver`, the result of choose_strategy().
    Strategy                      strategy = Strategy::undefined;
    std::unique_ptr<StepRecorder> recorder;
    std::unique_ptr<LoadPath>     path;

    Results found;
    /// True for each body whose axis mesh may be refined: axes with `auto`
    /// number of elements, in comparison models and in runs to a tolerance.
    std::vector<bool> may_refine;
    /// True if the last load step is of an earlier run and has only its state.
    bool last_has_state_only = false;
    bool revised             = false;
  };

  /// Computes the natural and buckling modes and the harmonic response that the
  /// scene of @p built requests about @p state, the last load step of @p
  /// results, and sets them there. @p system has solved it, and is null for
  /// finite rotations. With linear kinematics, natural modes include the
  /// stresses of the state unless it is beyond the linear range (a note).
  /// Throws InputError for buckling modes without stresses or with finite
  /// rotations, and as natural_modes(), buckling_modes() and HarmonicResponse.
  /// Collective.
  void
  find_modes(const BuiltScene &built,
             LinearSystem     *system,
             const State      &state,
             Results          &results);
} // namespace lamella

#endif
