// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_results_folder_h
#define lamella_report_results_folder_h

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
} // namespace lamella

#endif
