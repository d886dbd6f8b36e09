// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_run_scene_h
#define lamella_run_run_scene_h

#include <lamella/run/simulation.h>

#include <functional>
#include <iosfwd>
#include <string>

namespace lamella
{
  /// The simulation of @p scene, out of @p text: faults that show when bodies
  /// are built are InputErrors with the line of the text, too. @p text is not
  /// kept.
  std::unique_ptr<Simulation>
  make_simulation(const Scene &scene, const SceneText &text, std::ostream &out);

  /// Is called when all steps are solved, and may add what it finds out
  /// (Simulation::set_goals()) before it is written.
  using Afterthought = std::function<void()>;

  /**
   * Solves @p simulation, each step written into @p directory when it is done
   * (ResultsWriter), and what a user wants to read of it to its output. With
   * @p resume the run that is there goes on after the steps that it has.
   * Throws as Simulation::solve() does, and InputError for a folder that cannot
   * be written, is another run's, or has nothing to resume. Where a step fails,
   * the summary of those before it is written before that is thrown.
   */
  void
  run_scene(Simulation         &simulation,
            const std::string  &directory,
            const bool          resume     = false,
            const Afterthought &afterwards = {});

  /// Writes what @p simulation has solved into @p directory, as run_scene()
  /// does, all of it at once. Throws InputError for a folder that cannot be
  /// written.
  void
  write_run(Simulation &simulation, const std::string &directory);

  /// Prints what a user wants to read of the last load step to @p to.
  void
  print_results(const Simulation  &simulation,
                const std::string &directory,
                std::ostream      &to);

  /// Prints plies, laminate stiffnesses, sections as beams, bodies, contacts
  /// and notes to the output of @p simulation, without solving: what --validate
  /// is for. Writes sections/ of a run into the folder @p directory, for
  /// pictures, unless it is empty.
  void
  print_validation(const Simulation &simulation, const std::string &directory);
} // namespace lamella

#endif
