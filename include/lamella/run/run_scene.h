// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_run_scene_h
#define lamella_run_run_scene_h

#include <lamella/run/simulation.h>

#include <functional>
#include <iosfwd>
#include <string>

namespace lamella
{
  /// Returns the unsolved simulation of @p scene, which was read from @p text.
  /// InputErrors contain the line of @p text. Prints progress to @p out.
  std::unique_ptr<Simulation>
  make_simulation(const Scene &scene, const SceneText &text, std::ostream &out);

  /// Callback after the last load step; may add results, such as error bars.
  using PostProcessing = std::function<void()>;

  /// Solves @p simulation, writes each completed load step into the folder
  /// @p directory (ResultsWriter) and prints the main results. With @p resume,
  /// continues the run in this folder. Throws what Simulation::solve() throws,
  /// after writing the completed steps, and InputError if the folder cannot be
  /// written, belongs to another run, or has no step to resume from.
  void
  run_scene(Simulation           &simulation,
            const std::string    &directory,
            const bool            resume          = false,
            const PostProcessing &post_processing = {});

  /// Writes the results of all load steps of @p simulation into the folder @p
  /// directory, with the same files as run_scene().
  void
  write_run(Simulation &simulation, const std::string &directory);

  /// Prints the main results of the last load step, and @p directory, to @p to.
  void
  print_results(const Simulation  &simulation,
                const std::string &directory,
                std::ostream      &to);

  /// Prints plies, laminate stiffnesses, beam properties of sections, bodies,
  /// contacts and notes of @p simulation, without solving (--validate). Unless
  /// @p directory is empty, writes section meshes to its subfolder `sections`.
  void
  print_validation(const Simulation &simulation, const std::string &directory);
} // namespace lamella

#endif
