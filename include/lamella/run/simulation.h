// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `run`: one scene from its description to its results. It owns the
// driver, Simulation, in which the main loop is, and the command line. All work
// is done by the rooms below, in the order that stands here; the driver never
// does mechanics of its own.
//
// Where to start reading: Simulation::solve() and what it calls, in
// source/run/simulation.cc, is the whole program in a page: build, factorise,
// and for each load step the linear solution, contact on top of it, checks,
// results.

#ifndef lamella_run_simulation_h
#define lamella_run_simulation_h

#include <lamella/adapt/node_fields.h>
#include <lamella/contact/search_check.h>
#include <lamella/recover/plausibility.h>
#include <lamella/recover/sampler.h>
#include <lamella/recover/strength_sweep.h>
#include <lamella/report/results_writer.h>
#include <lamella/scene/scene.h>
#include <lamella/solve/contact_solver.h>
#include <lamella/solve/memory_budget.h>
#include <lamella/solve/results.h>

#include <deal.II/base/timer.h>

#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>

namespace lamella
{
  /**
   * The main loop: from a scene to its results. For each load factor t in turn
   *   1. the linear solution without contact (ContactSolver::solve_free()),
   *   2. contact on top of it, from the active rows of the step before, and the
   *      release of stabilising springs,
   *   3. checks, which end the run if the state is not to be trusted, or if a
   *      contact's search distance was too short,
   *   4. fields at probes, lines and cuts, and the reserve factors of plies.
   * Kinematics is linear and contact without friction or memory, so a step
   * depends on the one before by its start only, not by its result.
   *
   * Owns all that is built of the scene, and the results. On several processes
   * each builds and holds all of it and calls the same functions; who does not
   * speak for all hands in a stream that goes nowhere.
   */
  class Simulation
  {
  public:
    /// Builds everything that a scene can be wrong in: bodies, supports, loads,
    /// contacts, probes. Throws InputError; nothing is written. Progress goes
    /// to @p out, which is referred to. What it needs of @p given is copied. No
    /// stiffness matrix of a body is assembled yet. Fields of SV-N are chosen
    /// by @p rules. Collective.
    Simulation(const Scene      &given,
               std::ostream     &out,
               const FieldRules &rules = FieldRules());
    ~Simulation();

    /// @p quantities, which are of the scene, those that only References ask
    /// for in the lower ply where their probe lies between two. Throws
    /// InputError for one that names a ply that its probe is not in, or none
    /// where plies differ (Sampler::check()). Goals are such.
    std::vector<NamedQuantity>
    in_plies(std::vector<NamedQuantity> quantities) const;

    /// Is handed the results each time that a load step is added to them; what
    /// it throws ends the run.
    using Observer = std::function<void(const Results &)>;

    /**
     * Solves all load steps that are not solved yet, and returns results().
     * Throws InputError if the memory does not suffice, NumericsError for a
     * step that cannot be solved or is not to be trusted, or in which a search
     * distance turns out too short; results() then has the steps before it.
     * With an @p observer the state and the tables of a step are dropped when
     * the next one is there: what it has not taken is gone. Without one all
     * steps stay whole. Collective.
     */
    const Results &
    solve(const Observer &observer = {});

    /// What is solved so far; before solve() names, notes and loads only. It
    /// lives as long as this object.
    const Results &
    results() const
    {
      return found;
    }

    /// Is handed the results when all steps are solved, and may add what it
    /// finds out (estimates of errors, say) before they are written.
    using Afterthought = std::function<void(Results &)>;

    /**
     * solve(), each step written into @p directory when it is done
     * (ResultsWriter), and what a user wants to read of it to the output. With
     * @p resume the run that is there goes on after the steps that it has.
     * Throws as solve() does, and InputError for a folder that cannot be
     * written, is another run's, or has nothing to resume. Where a step fails,
     * the summary of those before it is written before that is thrown.
     */
    void
    run(const std::string  &directory,
        const bool          resume     = false,
        const Afterthought &afterwards = {});

    /// Writes what is solved into @p directory, as run() does, all of it at
    /// once, with what is handed in. Throws InputError for a folder that cannot
    /// be written.
    void
    write(const std::string &directory, const std::vector<GoalResult> &goals);

    /// Prints what a user wants to read of the last load step to @p to.
    void
    print_results(const std::string &directory, std::ostream &to) const;

    /// The scene as it is solved: as it was given, with the axes that grade
    /// themselves made.
    const Scene &
    solved_scene() const
    {
      return scene;
    }

    /// By which the fields of SV-N were chosen.
    const FieldRules &
    rules() const
    {
      return field_rules;
    }

    /// What is solved, for who looks into the error of it: the structure, the
    /// gap rows of its contacts, and what solves it, which is there once
    /// solve() was called.
    const Structure &
    solved_structure() const
    {
      return *structure;
    }
    const std::vector<ContactInterface> &
    interfaces() const
    {
      return contacts;
    }
    const GapRows &
    rows() const
    {
      return gap_rows;
    }
    ContactSolver &
    contact_solver() const
    {
      return *solver;
    }

    /// Prints plies, laminate stiffnesses, sections as beams, bodies, contacts
    /// and notes, without solving: what --validate is for. Writes sections/ of
    /// a run into the folder @p directory, for pictures, unless it is empty.
    void
    print_validation(const std::string &directory) const;

  private:
    // Building.

    /// All of what follows.
    void
    build();
    /// Builds all anew with all fields of the section for bodies that had fewer
    /// of its own. False, and nothing is done, where there are none.
    bool
    take_all_fields();
    /// Section meshes, bodies, supports, loads and stabilising springs.
    void
    build_structure();
    /// The bodies, each node with the fields that the scene wants there: where
    /// they depend on what touches a body, conditions and contacts are made
    /// once to see it.
    Bodies
    make_bodies_with_fields();
    /// Finds the motions that holds among the supports take out of
    /// @p bodies, which are made; contacts are, once more, to see what may
    /// touch them.
    void
    hold_bodies(const Bodies &bodies);
    /// Search and pairing: the gap rows of all contacts, none twice.
    void
    build_contacts();
    /// What looks for failure, if the scene asks for it.
    void
    build_strength();
    /// What results say of the scene itself: names, sizes, notes.
    void
    describe();

    // Solving.

    /// All load steps that are left.
    const Results &
    solve_as_built(const Observer &observer);
    /// Looks whether the matrices fit, assembles and factorises, and makes the
    /// strategy that finds which rows are active.
    void
    prepare();
    /// The state at load factor zero of heated bodies: what stays of the
    /// stresses when loads grow.
    void
    find_cured_state();
    /// That, or null where nothing is heated.
    const BlockVector *
    cured_state() const
    {
      return cured ? &*cured : nullptr;
    }
    /// Load step number @p step, from 1, at load factor @p factor: `state` and
    /// one more element of the results' steps.
    void
    solve_step(const unsigned int step,
               const double       factor,
               const Observer    &observer);
    /// The state at load factor @p factor, contact included, from the present
    /// one; throws as solve() does where it is not to be trusted.
    Checks
    solve_state(const double factor);
    /// The present state's checks; throws as solve_state() does.
    Checks
    checked(const double factor);
    /// Gives the last of the steps that an earlier run has solved, of which
    /// there are the state and what was said of it, its checks and rows again:
    /// there is something to be done with it though no step is left.
    void
    complete_last_step();
    /// The load at which the smallest reserve factor is 1
    /// (FirstFailureSearch). Says in an endnote where nothing fails or states
    /// end. The state is then again that of the last load step.
    void
    find_first_failure();
    /// Solves at @p factor: what that comes to, and its reserve factors into
    /// @p plies. Where it throws the state stays what it was.
    FailureTrial
    try_for_failure(const double factor, std::vector<PlyReserve> &plies);
    /// The present state as results; @p previous, that of the step before,
    /// tells which pairs began and ceased to touch.
    StepResults
    take_results(const unsigned int step,
                 const double       factor,
                 const Checks      &checks,
                 const State       &previous) const;
    /// The measures of the last of the steps found, into it.
    void
    take_measures();
    /// What acts on faces in the present state, that of load factor @p factor.
    FaceTractions
    tractions_at(const double factor) const;
    /// What the files of a run are made of, beyond results.
    ResultsWriter::Scenery
    scenery() const;
    /// Reserve factors of plies of the present state, and warnings of places
    /// that tell nothing, into @p results.
    void
    take_strength(StepResults &results, const FaceTractions &tractions) const;
    /// Seconds, memory and solvers so far.
    void
    count_costs();

    /// The stiffness with what solves with each body; tells how large a factor
    /// becomes.
    std::shared_ptr<const Linearisation>
    linearise(const MemoryBudget &budget);
    /// Contact, body and position of the gap row @p row, for messages.
    std::string
    describe_row(const unsigned int row) const;
    /// What the user should know of this load step: of the state, and of what
    /// pairing assumed (small sliding, collinear normals).
    std::vector<std::string>
    warnings_of_step(const double factor, const Checks &checks) const;
    /// What the holds of bodies bear where contact forces do not balance in
    /// motions that they take out.
    std::vector<std::string>
    warnings_of_holds(const Checks &checks) const;

    // What is to be solved.
    /// As given, with the axes that grade themselves made.
    Scene         scene;
    std::ostream &out;
    FieldRules    field_rules;
    /// Wall seconds of each Phase, and of the object's whole life.
    dealii::TimerOutput timer;
    dealii::Timer       wall;
    /// All sections of the scene, whether a body has them or not.
    SectionMeshes              sections;
    std::unique_ptr<Structure> structure;
    /// Of each contact its rows with their geometry, and what tells whether
    /// its search distance was enough.
    std::vector<ContactInterface> contacts;
    std::vector<SearchCheck>      search_checks;
    /// What the choice of fields has to say.
    std::vector<std::string> field_notes;
    /// The places of probes, lines and cuts in their bodies.
    std::unique_ptr<Sampler> sampler;
    /// Null where the scene asks for no criteria.
    std::unique_ptr<StrengthSweep> strength;
    /// Tells what looks like a slip of units.
    std::unique_ptr<Plausibility> plausibility;

    // How it is solved.

    /// A view of the rows of `contacts`, numbered through.
    GapRows gap_rows;
    /// Null before prepare(). Refers to structure and rows.
    std::unique_ptr<ContactSolver> solver;

    // Where it stands, and what was found.

    /// Of the last load step; empty before the first.
    State   state;
    Results found;
    /// Whether the last step comes from an earlier run and has its state only.
    bool last_is_bare = false;
    /// What find_cured_state() has found.
    std::optional<BlockVector> cured;
  };
  /// The simulation of @p scene, out of @p text: faults that show when bodies
  /// are built are InputErrors with the line of the text, too. @p text is not
  /// kept.
  std::unique_ptr<Simulation>
  make_simulation(const Scene &scene, const SceneText &text, std::ostream &out);
} // namespace lamella

#endif
