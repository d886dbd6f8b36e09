// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `report`: output of results. From Results it writes all files of
// a run (tables, summary, VTU, restart) and the console output. It computes
// the stiffness of sections, and reads restart data. page.h runs `lamella
// report`. Apart from these it does not compute.

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
  /// Writes the results of a run to its folder. After each load step it writes
  /// VTU files, rows of all tables, the summary, and last the restart data with
  /// the sizes of tables. A later failure does not damage completed steps:
  /// other files are replaced atomically. All functions are collective.
  class ResultsWriter
  {
  public:
    /// Objects other than Results that the output requires.
    struct OutputSources
    {
      const Structure &structure;
      /// Contacts in the order of Results.
      const std::vector<ContactInterface> &contacts;
      /// Section meshes by name.
      const std::map<std::string, std::shared_ptr<const SectionMesh>> &sections;
      /// Text of the scene with all entries.
      const std::string &resolved;
      /// True if VTU files are written.
      bool write_vtu = true;
      /// Strength analysis for reserve factors in VTU files; may be null.
      const StrengthSweep *strength = nullptr;
    };

    /// Locks the folder @p directory for this run. @p output_sources is called
    /// at each load step. Throws InputError as ResultsFolder does.
    ResultsWriter(const std::string                    &directory,
                  const std::function<OutputSources()> &output_sources);

    /// Returns the completed load steps of the run in the folder (Restart) and
    /// removes later rows of tables. Must be called before any step is written.
    /// Throws InputError as read_restart() does, and if table rows are missing.
    std::vector<StepResults>
    resume();

    /// Writes the last load step of @p results, which must have table rows. The
    /// first call removes earlier results and writes scene.prm, sections,
    /// fields.csv and table headers. Throws InputError on failure.
    void
    write_step(const Results &results);

    /// Writes the summary after the last load step, with checks, goals and
    /// first failure; no output if no step was solved.
    void
    write_outcome(const Results &results);

    /// Writes the summary at the end of the run, and marks the restart data as
    /// finished if all steps were solved.
    void
    write_end(const Results &results);

    const ResultsFolder &
    folder() const
    {
      return place;
    }

  private:
    /// Appends the rows of the last step to all tables.
    void
    write_tables(const Results &results);
    /// Constructs the surfaces of all contacts for the current pairs of points.
    void
    make_surfaces();
    /// Writes VTU files of bodies and contacts, and their collections.
    void
    write_vtu_files(const StepResults &step);
    /// Writes the summary and the restart data.
    void
    write_progress(const Results &results);

    std::function<OutputSources()> output_sources;
    ResultsFolder                  place;
    /// Surface of each contact; empty if no VTU files are written.
    std::vector<ContactSurface> surfaces;
    /// Restart data after the last completed step.
    Restart standing;
  };
} // namespace lamella

#endif
