// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `run`: one scene from its description to its results. It owns the
// driver, Simulation, in which the main loop is, and the command line. All work
// is done by the rooms below, in the order that stands here; the driver never
// does mechanics of its own.

#ifndef lamella_run_simulation_h
#define lamella_run_simulation_h

#include <lamella/contact/search_check.h>
#include <lamella/recover/sampler.h>
#include <lamella/scene/scene.h>
#include <lamella/solve/contact_solver.h>
#include <lamella/solve/memory_budget.h>
#include <lamella/solve/results.h>

#include <deal.II/base/timer.h>

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>

namespace lamella
{
  /// The main loop: from a scene to its results.
  class Simulation
  {
  public:
    /// Builds everything that a scene can be wrong in: bodies, supports, loads,
    /// contacts, probes. Throws InputError; nothing is written. Progress goes
    /// to @p out. What it needs of @p given is copied.
    Simulation(const Scene &given, std::ostream &out);
    ~Simulation();

    /// Is handed the results each time that a load step is added to them.
    using Observer = std::function<void(const Results &)>;

    /**
     * Solves all load steps. Throws InputError if the memory does not suffice,
     * NumericsError for a step that cannot be solved; results() then has those
     * before it. With an @p observer the state and the tables of a step are
     * dropped when the next one is there: what it has not taken is gone.
     */
    const Results &
    solve(const Observer &observer = {});

    /// What is solved so far.
    const Results &
    results() const
    {
      return found;
    }

    /**
     * solve(), each step written into @p directory when it is done
     * (ResultsWriter), and what a user wants to read of it to the output. With
     * @p resume the run that is there goes on after the steps that it has.
     */
    void
    run(const std::string &directory, const bool resume = false);

    /// Prints plies, laminate stiffnesses, bodies and contacts, without
    /// solving.
    void
    print_validation() const;

  private:
    // Building.
    void
    build_structure();
    void
    build_contacts();
    void
    describe();

    // Solving.
    void
    prepare();
    void
    solve_step(const unsigned int step,
               const double       factor,
               const Observer    &observer);
    StepResults
    take_results(const unsigned int step,
                 const double       factor,
                 const Checks      &checks,
                 const State       &previous) const;
    /// Seconds, memory and solvers so far.
    void
    count_costs();

    /// What solves with each body; tells how large a factor becomes.
    void
    make_solvers(const MemoryBudget &budget);
    /// Contact, body and position of the gap row @p row, for messages.
    std::string
    describe_row(const unsigned int row) const;
    /// What the user should know of this load step.
    std::vector<std::string>
    warnings_of_step(const double factor, const Checks &checks) const;
    void
    print_results(const std::string &directory) const;

    // What is to be solved.
    const Scene         scene;
    std::ostream       &out;
    dealii::TimerOutput timer;
    dealii::Timer       wall;
    /// All sections of the scene, whether a body has them or not.
    SectionMeshes                 sections;
    std::unique_ptr<Structure>    structure;
    std::vector<ContactInterface> contacts;
    std::vector<SearchCheck>      search_checks;
    std::unique_ptr<Sampler>      sampler;

    // How it is solved.
    GapRows                        gap_rows;
    std::unique_ptr<ContactSolver> solver;

    // Where it stands, and what was found.
    State   state;
    Results found;
  };
  /// The simulation of @p scene, out of @p text: faults that show when bodies
  /// are built are InputErrors with the line of the text, too.
  std::unique_ptr<Simulation>
  make_simulation(const Scene &scene, const SceneText &text, std::ostream &out);
} // namespace lamella

#endif
