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
   * the first of this one comes.
   */
  class ResultsFolder
  {
  public:
    /// Throws InputError if @p path cannot be created and written, or if
    /// another run is at work there. On several processes all call it.
    explicit ResultsFolder(const std::string &path);
    /// Gives the folder back; removed if it was created and is still empty.
    ~ResultsFolder();
    ResultsFolder(const ResultsFolder &) = delete;

    const std::string &
    path() const
    {
      return folder;
    }

    /// To be called before anything is written: the first call removes what an
    /// earlier run has left, and nothing that a run does not write. Throws
    /// InputError if the folder has gone since. On several processes all call
    /// it.
    void
    make_room();

    /// What an earlier run has left stays: this one goes on with it.
    void
    keep()
    {
      has_room = true;
    }

    /// Whether an earlier run's summary is there.
    bool
    has_earlier_results() const;

  private:
    void
    lock();
    bool
    is_still_there() const;

    std::string folder;
    bool        is_new = false, has_room = false;
    int         descriptor = -1;
  };
} // namespace lamella

#endif
