// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_simulation_h
#define lamella_run_simulation_h

#include <lamella/contact/search_check.h>
#include <lamella/report/contact_surface.h>
#include <lamella/report/recorder.h>
#include <lamella/report/results_folder.h>
#include <lamella/report/summary.h>
#include <lamella/scene/scene.h>
#include <lamella/solve/checks.h>
#include <lamella/solve/memory_budget.h>
#include <lamella/solve/newton.h>

#include <deal.II/base/timer.h>

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
    /// to
    /// @p out. @p scene is referred to.
    Simulation(const Scene &scene, std::ostream &out);

    /// Solves all load steps and writes the results into @p directory. Throws
    /// NumericsError; the load steps before the failing one are then written.
    void
    run(const std::string &directory);

    /// Prints plies, laminate stiffnesses, bodies and contacts, without
    /// solving.
    void
    print_validation() const;

  private:
    /// Factorises what the strategy needs, if it fits into @p budget.
    void
    prepare_strategy(const MemoryBudget &budget);
    /// Contact, body and position of the gap row @p row, for messages.
    std::string
    describe_row(unsigned int row) const;
    void
    solve_step(const unsigned int step, const double factor);
    /// Those of one contact, numbered from 0.
    std::vector<unsigned int>
    active_rows(const unsigned int contact) const;
    /// What the user should know of this load step.
    void
    add_warnings(const unsigned int step,
                 const double       factor,
                 const Checks      &checks);
    void
    write_vtu_files(const unsigned int step, const double factor);
    void
    write_results();

    // What is to be solved.
    const Scene                  &scene;
    std::ostream                 &out;
    dealii::TimerOutput           timer;
    dealii::Timer                 wall;
    std::unique_ptr<Structure>    structure;
    std::vector<ContactInterface> contacts;
    std::vector<SearchCheck>      search_checks;

    // How it is solved.
    std::vector<GapRow>              gap_rows;
    std::unique_ptr<ContactStrategy> strategy;
    std::unique_ptr<Newton>          newton;

    // Where it stands, and what is kept.
    State                     state;
    Summary                   summary;
    std::unique_ptr<Recorder> recorder;
    /// All sections of the scene, whether a body has them or not.
    SectionMeshes                  sections;
    std::unique_ptr<ResultsFolder> folder;
    std::vector<ContactSurface>    contact_surfaces;
    /// Name of a collection -> its load steps with their files.
    std::map<std::string, std::vector<std::pair<double, std::string>>>
      vtu_files;
  };
} // namespace lamella

#endif
