// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_results_folder_h
#define lamella_report_results_folder_h

#include <lamella/recover/results.h>

#include <cstdint>
#include <map>
#include <string>

namespace lamella
{
  /// Folder for the results of one analysis. While this object exists, a file
  /// lock excludes other runs. Before the first new file is written, earlier
  /// results are removed, the summary first, so that a summary never stands
  /// beside files of another run. Only the root process writes.
  class ResultsFolder
  {
  public:
    /// Creates the folder @p path with parents and locks it. Throws InputError
    /// if it cannot be written or is locked by another run. Collective.
    explicit ResultsFolder(const std::string &path);
    /// Unlocks the folder; removes it if it is new and empty.
    ~ResultsFolder();
    ResultsFolder(const ResultsFolder &) = delete;

    /// Returns the path passed to the constructor.
    const std::string &
    path() const
    {
      return folder;
    }

    /// Removes the result files (no others) of an earlier analysis; only the
    /// first call has an effect. Must be called before any output. Throws
    /// InputError if the folder no longer exists. Collective.
    void
    make_room();

    /// Removes the result files of this analysis, if make_room() was called.
    void
    discard()
    {
      if (is_cleared)
        {
          is_cleared = false;
          make_room();
        }
    }

    /// Disables make_room(), so that earlier results are not removed.
    void
    keep()
    {
      is_cleared = true;
    }

    /// Returns true if the folder has the summary of an earlier analysis; false
    /// after make_room() or keep().
    bool
    has_earlier_results() const;

  private:
    std::string folder;
    bool        is_new     = false; ///< True if this object created the folder.
    bool        is_cleared = false; ///< True after make_room() or keep().
    /// Descriptor of the locked folder; -1 except on the root process.
    int descriptor = -1;
  };

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

  /// Implements `lamella report DIR`: writes the results in @p folder to the
  /// self-contained HTML file @p target. The current process is replaced by the
  /// script scripts/report.py (doc/guides/report.md). Throws InputError if the
  /// script, or python3 with Jinja2, is not found.
  [[noreturn]] void
  make_page(const std::string &folder, const std::string &target);
} // namespace lamella

#endif
