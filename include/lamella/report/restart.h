// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_restart_h
#define lamella_report_restart_h

#include <lamella/solve/results.h>

#include <cstdint>
#include <map>
#include <string>

namespace lamella
{
  /// Name of a collection (`solution`, `contact_NAME`) -> its load steps with
  /// their VTU files.
  using VtuFiles =
    std::map<std::string, std::vector<std::pair<double, std::string>>>;

  /**
   * Where a run stands after a whole load step: what it takes to go on, kept in
   * the file `restart` of its folder. A file of doubles as they are in memory:
   * a run that goes on from it does what the uninterrupted one would have done.
   */
  struct Restart
  {
    /// The program's version and the resolved scene that the run is of.
    std::string version, scene;
    /// Whether all load steps are done.
    bool finished = false;
    /// The steps so far: their numbers, load factors, iterations, changes and
    /// warnings; of the last one the whole state.
    std::vector<StepResults> steps;
    /// Bytes of each table.
    std::map<std::string, std::uint64_t> sizes;
    VtuFiles                             vtu_files;
  };

  /// Keeps @p restart in the folder @p directory. Throws InputError if it
  /// cannot.
  void
  write_restart(const Restart &restart, const std::string &directory);

  /**
   * What the run in @p directory left. Throws InputError if there is none, if
   * it is of another version of the program or of another scene than @p scene,
   * resolved, or if it is finished: nothing is left to resume.
   */
  Restart
  read_restart(const std::string &directory, const std::string &scene);
} // namespace lamella

#endif
