// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_run_scene_h
#define lamella_run_run_scene_h

#include <lamella/run/simulation.h>

#include <functional>
#include <iosfwd>
#include <string>

namespace lamella
{
  /// Returns the simulation of @p scene, read from @p text, which is not kept.
  /// Errors of building bodies are also InputErrors with the line of the text.
  std::unique_ptr<Simulation>
  make_simulation(const Scene &scene, const SceneText &text, std::ostream &out);

  /// Function called after all steps are solved. It may add results
  /// (Simulation::set_goals()) before these are written.
  using PostProcessing = std::function<void()>;

  /// Solves @p simulation, writes each completed step into @p directory
  /// (ResultsWriter) and prints the main results to the simulation's output.
  /// With @p resume, the run in the folder is continued after its completed
  /// steps. Throws what Simulation::solve() throws, and InputError for a folder
  /// that cannot be written, belongs to another run, or has nothing to resume.
  /// If a step fails, the summary of the steps before is written first.
  void
  run_scene(Simulation           &simulation,
            const std::string    &directory,
            const bool            resume          = false,
            const PostProcessing &post_processing = {});

  /// Writes all solved steps of @p simulation into @p directory, as run_scene()
  /// does. Throws InputError for a folder that cannot be written.
  void
  write_run(Simulation &simulation, const std::string &directory);

  /// Prints the main results of the last load step to @p to.
  void
  print_results(const Simulation  &simulation,
                const std::string &directory,
                std::ostream      &to);

  /// Prints plies, laminate stiffnesses, beam properties of sections, bodies,
  /// contacts and notes to the output of @p simulation, without solving
  /// (--validate). Writes sections/ into the folder @p directory, unless it is
  /// empty.
  void
  print_validation(const Simulation &simulation, const std::string &directory);
} // namespace lamella

#endif
