// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_results_folder_h
#define lamella_report_results_folder_h

#include <string>

namespace lamella
{
  /// Folder of the results of one run. It is locked for the lifetime of the
  /// object by a system lock. Earlier results are removed before the first new
  /// one is written. The summary is removed first and written with the first
  /// completed load step, so that it always belongs to the other files. The
  /// root process locks and writes, and broadcasts errors.
  class ResultsFolder
  {
  public:
    /// Creates the folder @p path with its parents and locks it. Throws
    /// InputError if it cannot be created or written, or is locked by another
    /// run. Collective.
    explicit ResultsFolder(const std::string &path);
    /// Unlocks the folder; removes it if it was created here and is empty.
    ~ResultsFolder();
    ResultsFolder(const ResultsFolder &) = delete;

    /// Returns the path as given.
    const std::string &
    path() const
    {
      return folder;
    }

    /// Removes the results of an earlier run at the first call, and folders
    /// that are then empty; other files stay. Must be called before any output.
    /// Throws InputError if the folder has disappeared. Collective.
    void
    make_room();

    /// Keeps the results of an earlier run: make_room() has no effect.
    void
    keep()
    {
      is_cleared = true;
    }

    /// Returns whether the summary of an earlier run exists(not after
    /// make_room(), keep()).
    bool
    has_earlier_results() const;

  private:
    /// Locks the folder; descriptor stays -1 if another process has the lock.
    void
    lock();
    /// Returns whether the folder of that name is still the locked one.
    bool
    still_exists() const;

    std::string folder;
    /// True if created here, and true if earlier results are dealt with.
    bool is_new = false, is_cleared = false;
    /// Descriptor of the locked folder; -1 except on the root process.
    int descriptor = -1;
  };
} // namespace lamella

#endif
