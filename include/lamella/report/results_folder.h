// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_results_folder_h
#define lamella_report_results_folder_h

#include <string>

namespace lamella
{
  /**
   * The folder of one run's results. It is this run's alone while the object
   * lives (a lock of the system's, which ends with the process however that
   * ends), and holds results of one run only: those of an earlier one go before
   * the first of this one comes. The summary goes first and comes again with
   * the first whole load step, so a summary belongs to the files around it.
   *
   * Lock and files are the work of the process that speaks for all; the others
   * hear of it what it found.
   */
  class ResultsFolder
  {
  public:
    /// Creates the folder @p path with those above it and locks it. Throws
    /// InputError if @p path cannot be created and written, or if another run
    /// is at work there. Nothing in it is touched yet. On several processes all
    /// call it.
    explicit ResultsFolder(const std::string &path);
    /// Gives the folder back; removed if it was created and is still empty.
    ~ResultsFolder();
    ResultsFolder(const ResultsFolder &) = delete;

    /// As it was given.
    const std::string &
    path() const
    {
      return folder;
    }

    /// To be called before anything is written: the first call removes what an
    /// earlier run has left, files that are called as a run's results or their
    /// pictures, and folders that are empty then; everything else stays. Throws
    /// InputError if the folder has gone since. On several processes all call
    /// it.
    void
    make_room();

    /// What an earlier run has left stays: this one goes on with it, and
    /// make_room() removes nothing.
    void
    keep()
    {
      has_room = true;
    }

    /// Whether an earlier run's summary is there: until make_room() or keep().
    bool
    has_earlier_results() const;

  private:
    /// Takes the system's lock on the folder; descriptor stays -1 if another
    /// process has it.
    void
    lock();
    /// Whether the folder of that name is still the one that was locked.
    bool
    is_still_there() const;

    std::string folder;
    /// Whether it was created here, and whether earlier results are dealt with.
    bool is_new = false, has_room = false;
    /// Of the locked folder; -1 on processes that do not speak.
    int descriptor = -1;
  };
} // namespace lamella

#endif
