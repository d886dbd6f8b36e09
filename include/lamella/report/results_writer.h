// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `report`: how results are told. It owns the folder of a run and all
// files in it (tables, summary, VTU, what a run is resumed from) and what the
// console says, made from Results. It never computes what is not in Results,
// and nothing in it reads what it wrote but the restart.

#ifndef lamella_report_results_writer_h
#define lamella_report_results_writer_h

#include <lamella/report/contact_surface.h>
#include <lamella/report/restart.h>
#include <lamella/report/results_folder.h>
#include <lamella/report/tables.h>
#include <lamella/shape/section_geometry.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * Writes the results of a run into its folder, each load step when it has
   * ended: rows of all tables, VTU files and their collections, the summary,
   * and what it takes to go on from there. Whatever ends the run later leaves
   * the steps before it whole. All functions are called by all processes.
   */
  class ResultsWriter
  {
  public:
    /// What pictures are made of, beyond results.
    struct Scenery
    {
      const Structure                     &structure;
      const std::vector<ContactInterface> &contacts;
      const std::map<std::string, std::shared_ptr<const SectionMesh>> &sections;
      /// The scene as it is run.
      const std::string &resolved;
      bool               write_vtu = true;
    };

    /// The results of @p scenery go into the folder @p directory, which is this
    /// run's from now on. Throws InputError (ResultsFolder).
    ResultsWriter(const std::string &directory, const Scenery &scenery);

    /// The steps that the run in the folder has whole; the tables are cut to
    /// them. Throws InputError (read_restart()).
    std::vector<StepResults>
    resume();

    /// Writes the last load step of @p results. Throws InputError if that
    /// fails; the steps before are whole.
    void
    write_step(const Results &results);

    /// Writes the summary of @p results at the end of the run; nothing if no
    /// step was solved.
    void
    write_end(const Results &results);

    const ResultsFolder &
    folder() const
    {
      return place;
    }

  private:
    void
    write_tables(const Results &results);
    void
    write_vtu_files(const StepResults &step);
    void
    write_standing(const Results &results);

    Scenery                     scenery;
    ResultsFolder               place;
    std::vector<ContactSurface> surfaces;
    /// What is there so far.
    Restart standing;
  };
} // namespace lamella

#endif
