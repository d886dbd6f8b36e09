// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `report`: output of results. It writes the folder of a run with all
// its files (tables, summary, VTU, restart) and the console output, from
// Results. It computes only the stiffness of sections, and reads only the
// restart. page.h starts the Python program of `lamella report`.

#ifndef lamella_report_results_writer_h
#define lamella_report_results_writer_h

#include <lamella/recover/strength_sweep.h>
#include <lamella/report/contact_surface.h>
#include <lamella/report/restart.h>
#include <lamella/report/results_folder.h>
#include <lamella/report/tables.h>
#include <lamella/shape/section_geometry.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Writer of the results of a run into its folder. Each load step writes VTU
  /// files and collections, rows of all tables, the summary, and last the
  /// restart data with the sizes of the tables. Completed steps survive any
  /// later failure: files other than growing tables are replaced atomically.
  /// All functions are collective.
  class ResultsWriter
  {
  public:
    /// Objects that pictures are made from, besides results.
    struct OutputSources
    {
      /// Bodies to be drawn.
      const Structure &structure;
      /// Contacts in the order of Results.
      const std::vector<ContactInterface> &contacts;
      /// Meshes by name of the section.
      const std::map<std::string, std::shared_ptr<const SectionMesh>> &sections;
      /// Scene as it is run.
      const std::string &resolved;
      /// True if VTU files and their collections are written.
      bool write_vtu = true;
      /// Source of reserve factors in VTU files; null for none.
      const StrengthSweep *strength = nullptr;
    };

    /// Writes results into the folder @p directory, reserved for this run
    /// (ResultsFolder). Calls @p output_sources at each step. Throws
    /// InputError.
    ResultsWriter(const std::string                    &directory,
                  const std::function<OutputSources()> &output_sources);

    /// Returns the completed steps of the run in the folder (Restart) and cuts
    /// the tables to them. Must be called before any step is written. Throws
    /// InputError as read_restart() does, also if a table is too short.
    std::vector<StepResults>
    resume();

    /// Writes the last load step of @p results, which must have its rows. The
    /// first call removes earlier results and writes scene.prm, the sections,
    /// the fields of the nodes and the table headers. Throws InputError on
    /// failure.
    void
    write_step(const Results &results);

    /// Writes the summary of @p results after all steps, with the checks of the
    /// last one, goals and first failure; no output if no step was solved.
    void
    write_outcome(const Results &results);

    /// Writes the summary at the end of the run; if all steps were solved, the
    /// restart is marked as finished.
    void
    write_end(const Results &results);

    /// Returns the folder, owned by the writer.
    const ResultsFolder &
    folder() const
    {
      return place;
    }

  private:
    /// Appends the rows of the last step to all tables; creates them first.
    void
    write_tables(const Results &results);
    /// Makes the surfaces of all contacts in their present pairing.
    void
    make_surfaces();
    /// Writes the bodies, the contact surfaces and the collections.
    void
    write_vtu_files(const StepResults &step);
    /// Writes the summary and the restart.
    void
    write_progress(const Results &results);

    std::function<OutputSources()> output_sources;
    ResultsFolder                  place;
    /// Surface of each contact; none without VTU files.
    std::vector<ContactSurface> surfaces;
    /// Restart data so far.
    Restart standing;
  };
} // namespace lamella

#endif
