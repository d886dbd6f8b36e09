// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `report`: output of results. From Results it writes all files of
// a run (tables, summary, VTU, restart) and the console output. It computes
// the stiffness of sections, and reads restart data. make_page() runs `lamella
// report`. Apart from these it does not compute.

#ifndef lamella_report_results_writer_h
#define lamella_report_results_writer_h

#include <lamella/recover/strength_sweep.h>
#include <lamella/report/results_folder.h>
#include <lamella/report/tables.h>
#include <lamella/report/vtu.h>
#include <lamella/shape/section_geometry.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Writes the results of an analysis to its folder: after each load step VTU
  /// files, table lines, the summary, and last the restart data. These have the
  /// table sizes, so that resume() can remove lines of an incomplete load step.
  /// All functions are collective.
  class ResultsWriter
  {
  public:
    /// Objects other than Results that the output requires.
    struct OutputSources
    {
      const Structure &structure; ///< Bodies with loads and supports.
      /// Contacts in the order of Results.
      const std::vector<ContactInterface> &contacts;
      /// Section meshes by name.
      const std::map<std::string, std::shared_ptr<const SectionMesh>> &sections;
      /// Text of the scene with the values of all entries, for scene.prm.
      const std::string &resolved;
      bool write_vtu = true; ///< True: VTU files are written; false: none.
      /// Evaluation of reserve factors for VTU files; null if not requested.
      const StrengthSweep *strength = nullptr;
    };

    /// Locks the folder @p directory. @p output_sources returns the objects to
    /// write; it is called at each load step, since a run may replace them.
    /// Throws InputError if the folder cannot be written or is locked.
    ResultsWriter(const std::string                    &directory,
                  const std::function<OutputSources()> &output_sources);

    /// Returns the completed load steps of the interrupted analysis in the
    /// folder, and removes table lines of later steps. Must be called before
    /// any step is written. Throws InputError if restart data (read_restart())
    /// or table lines are missing.
    std::vector<StepResults>
    resume();

    /// Writes the last load step of @p results, whose fields must not have been
    /// released. The first call removes earlier results and writes scene.prm,
    /// sections, fields.csv and table headers. Throws InputError on failure.
    void
    write_step(const Results &results);

    /// Writes the summary after the last load step, with checks, goals and
    /// first failure; no output if no step was solved.
    void
    write_outcome(const Results &results);

    /// Writes the summary at the end of the analysis, and marks the restart
    /// data as finished if all load steps were solved.
    void
    write_end(const Results &results);

    /// Removes all that was written, if the scene turns out to be wrong.
    void
    discard()
    {
      place.discard();
    }

    /// Returns the locked folder of the results.
    const ResultsFolder &
    folder() const
    {
      return place;
    }

  private:
    /// Appends the results of the last load step to all tables.
    void
    write_tables(const Results &results);
    /// Writes VTU files of bodies and contacts, and their collections.
    void
    write_vtu_files(const StepResults &step);
    /// Writes VTU files NAME_NUMBER.vtu of the shapes of @p modes, scaled to 5
    /// % of the size of the scene, and their collection.
    void
    write_modes(const std::string &name, const std::vector<Mode> &modes);
    /// Writes the summary and the restart data.
    void
    write_progress(const Results &results);

    std::function<OutputSources()> output_sources;
    ResultsFolder                  place;
    /// Mesh of each contact; empty if no VTU files are written.
    std::vector<ContactSurface> surfaces;
    /// Restart data after the last completed step.
    Restart standing;
  };
} // namespace lamella

#endif
