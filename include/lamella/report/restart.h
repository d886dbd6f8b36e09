// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_restart_h
#define lamella_report_restart_h

#include <lamella/recover/results.h>

#include <cstdint>
#include <map>
#include <string>

namespace lamella
{
  /// Names of VTU files by collection (`solution`, `contact_NAME`), with the
  /// load step of each file in ascending order.
  using VtuFiles =
    std::map<std::string, std::vector<std::pair<double, std::string>>>;

  /// State of a run after a completed load step, from which the run is resumed,
  /// stored in the file `restart`. Doubles are stored exactly, in the format of
  /// the machine. Table rows beyond `sizes` belong to incomplete steps.
  struct Restart
  {
    /// Version of the program, and text of the scene with all entries.
    std::string version, scene;
    /// True if the run is complete; then only version and scene are stored.
    bool finished = false;
    /// Completed load steps, without checks and table rows; for the last step
    /// also displacements, contact state and data of the solution strategy.
    std::vector<StepResults> steps;
    /// Size [bytes] of each table by file name.
    std::map<std::string, std::uint64_t> sizes;
    /// VTU files of the completed steps.
    VtuFiles vtu_files;
  };

  /// Writes @p restart atomically to the folder @p directory. Throws InputError
  /// on failure. Must be called by one process only.
  void
  write_restart(const Restart &restart, const std::string &directory);

  /// Returns the restart data in @p directory. Throws InputError if it is
  /// missing or damaged, if version or @p scene differ, or the run is finished.
  Restart
  read_restart(const std::string &directory, const std::string &scene);
} // namespace lamella

#endif
