// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_restart_h
#define lamella_report_restart_h

#include <lamella/recover/results.h>

#include <cstdint>
#include <map>
#include <string>

namespace lamella
{
  /// VTU files by the name of their collection (`solution` or `contact_NAME`):
  /// number of each load step with the name of its file, in order.
  using VtuFiles =
    std::map<std::string, std::vector<std::pair<double, std::string>>>;

  /// Data from which an interrupted analysis is resumed after its last
  /// completed load step, stored in the file `restart` (binary, exact).
  struct Restart
  {
    std::string version; ///< Version of the program.
    std::string scene;   ///< Text of the scene with the values of all entries.
    /// True if the analysis is complete (the members below are then empty);
    /// false if load steps are missing.
    bool finished = false;
    /// Completed load steps, without checks and fields. Displacements and
    /// contact forces are stored for the last step only.
    std::vector<StepResults> steps;
    /// Size [bytes] of each table by file name. Data beyond this size belong to
    /// an incomplete load step.
    std::map<std::string, std::uint64_t> sizes;
    /// VTU files of the completed steps.
    VtuFiles vtu_files;
  };

  /// Writes @p restart atomically to the folder @p directory. Throws InputError
  /// on failure. Must be called by one process only.
  void
  write_restart(const Restart &restart, const std::string &directory);

  /// Returns the restart data in @p directory. Throws InputError if they are
  /// missing or damaged, if version or @p scene differ, or if the analysis is
  /// complete.
  Restart
  read_restart(const std::string &directory, const std::string &scene);
} // namespace lamella

#endif
