// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_restart_h
#define lamella_report_restart_h

#include <lamella/recover/results.h>

#include <cstdint>
#include <map>
#include <string>

namespace lamella
{
  /// VTU files by collection (`solution`, `contact_NAME`), with ascending load
  /// steps, without the folder.
  using VtuFiles =
    std::map<std::string, std::vector<std::pair<double, std::string>>>;

  /// State of a run after a completed load step, stored in the file `restart`
  /// of its folder. Doubles are stored as in memory, so that a resumed run
  /// gives the same results; the file is for the same program on the same kind
  /// of machine. Table rows beyond the stored sizes belong to incomplete steps.
  struct Restart
  {
    /// Version of the program and resolved scene.
    std::string version, scene;
    /// True if all load steps are done; only version and scene are stored then.
    bool finished = false;
    /// Completed steps: numbers, load factors, iterations, changes, reserve
    /// factors of plies and warnings; for the last one also the whole state and
    /// the data of the strategy. Checks and table rows are not stored.
    std::vector<StepResults> steps;
    /// Size in bytes of each table, by its name in the folder.
    std::map<std::string, std::uint64_t> sizes;
    /// Files of the collections so far.
    VtuFiles vtu_files;
  };

  /// Stores @p restart in the folder @p directory atomically. Throws InputError
  /// on failure. Called by one process.
  void
  write_restart(const Restart &restart, const std::string &directory);

  /// Returns the restart data in @p directory. Throws InputError if there is
  /// none, it is damaged or of another version or @p scene (resolved), or the
  /// run is finished. Any process may call it.
  Restart
  read_restart(const std::string &directory, const std::string &scene);
} // namespace lamella

#endif
