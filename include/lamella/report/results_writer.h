// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `report`: output of results. It owns the folder of a run with all
// files in it (tables, summary, VTU, restart) and the console output, made
// from Results. It never computes results, except the stiffness of sections, or
// reads its files, except the restart. `lamella report` makes a page
// from these files by a Python program that page.h starts.

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
  /**
   * Writer of the results of a run into its folder. At the end of each load
   * step it writes rows of all tables, VTU files and collections, the summary
   * and the restart data, so that completed steps survive any later failure.
   * All functions are collective.
   *
   * Order within a step: VTU files, rows of tables, summary, and last the
   * restart with the sizes of the tables. Files other than growing tables are
   * replaced atomically.
   */
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

    /// Writes results into the folder @p directory, which is reserved for this
    /// run during the lifetime of the object. Calls @p output_sources at each
    /// step. Throws InputError (ResultsFolder).
    ResultsWriter(const std::string                    &directory,
                  const std::function<OutputSources()> &output_sources);

    /// Returns the completed steps of the run in the folder (Restart) and cuts
    /// the tables to them. Has to be called before any step is written. Throws
    /// InputError (read_restart()), also if a table has become shorter.
    std::vector<StepResults>
    resume();

    /// Writes the last load step of @p results, which must have its rows. The
    /// first call removes earlier results and writes scene.prm, the sections,
    /// the fields of the nodes and the table headers. Throws InputError if that
    /// fails; earlier steps stay complete.
    void
    write_step(const Results &results);

    /// Writes the summary of @p results after all steps, which must have the
    /// checks of the last one, their goals and first failure; nothing if no
    /// step was solved.
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
    /// Appends the rows of the last step to all tables; creates them in the
    /// first step.
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
