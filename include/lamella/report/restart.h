// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_restart_h
#define lamella_report_restart_h

#include <lamella/recover/results.h>

#include <cstdint>
#include <map>
#include <string>

namespace lamella
{
  /// Name of a collection (`solution`, `contact_NAME`) -> its load steps with
  /// their VTU files.
  /// The steps ascend; a VTU file is named without the folder.
  using VtuFiles =
    std::map<std::string, std::vector<std::pair<double, std::string>>>;

  /**
   * Where a run stands after a whole load step: what it takes to go on, kept in
   * the file `restart` of its folder. A file of doubles as they are in memory:
   * a run that goes on from it does what the uninterrupted one would have done.
   * It is for the same program on the same kind of machine, not for exchange.
   *
   * Files of tables only grow, so their sizes tell which rows belong to whole
   * steps: what is beyond them is cut off before the run goes on.
   */
  struct Restart
  {
    /// The program's version and the resolved scene that the run is of.
    std::string version, scene;
    /// Whether all load steps are done. Then nothing else but version and scene
    /// is kept.
    bool finished = false;
    /// The steps so far: their numbers, load factors, iterations, changes,
    /// reserve factors of plies and warnings; of the last one the whole state
    /// and what the strategy had learnt. Neither checks nor rows of tables:
    /// those stand in the files.
    std::vector<StepResults> steps;
    /// Bytes of each table, by its name in the folder.
    std::map<std::string, std::uint64_t> sizes;
    /// What the collections list so far.
    VtuFiles vtu_files;
  };

  /// Keeps @p restart in the folder @p directory, in the place of an earlier
  /// one: the whole file or nothing. Throws InputError if it cannot. One
  /// process calls it.
  void
  write_restart(const Restart &restart, const std::string &directory);

  /**
   * What the run in @p directory left. Throws InputError if there is none, if
   * the file is damaged, if it is of another version of the program or of
   * another scene than @p scene, resolved, or if it is finished: nothing is
   * left to resume. All processes may read it.
   */
  Restart
  read_restart(const std::string &directory, const std::string &scene);
} // namespace lamella

#endif
