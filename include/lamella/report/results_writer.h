// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `report`: how results are told. It owns the folder of a run and all
// files in it (tables, summary, VTU, what a run is resumed from) and what the
// console says, made from Results. It never computes what is not in Results,
// but for the stiffness of sections, which no run needs, and nothing in it
// reads what it wrote but the restart. (The page of `lamella report` is made of
// these files by a Python program, which page.h starts.)

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
   * Writes the results of a run into its folder, each load step when it has
   * ended: rows of all tables, VTU files and their collections, the summary,
   * and what it takes to go on from there. Whatever ends the run later leaves
   * the steps before it whole. All functions are called by all processes.
   *
   * The order within a step is what makes it safe: pictures, rows of tables,
   * the summary, and last the restart, which says how long the tables were when
   * the step was whole. Each file but a table that grows is written beside its
   * place and renamed into it.
   */
  class ResultsWriter
  {
  public:
    /// Objects that pictures are made from, besides results.
    struct Scenery
    {
      /// The bodies that are drawn.
      const Structure &structure;
      /// In the order of the contacts in Results.
      const std::vector<ContactInterface> &contacts;
      /// By the name of the section.
      const std::map<std::string, std::shared_ptr<const SectionMesh>> &sections;
      /// The scene as it is run.
      const std::string &resolved;
      /// Whether to write VTU files and their collections.
      bool write_vtu = true;
      /// What reserve factors in VTU files come from; null for none.
      const StrengthSweep *strength = nullptr;
    };

    /// Writes results into the folder @p directory, which is reserved for this
    /// run during the lifetime of the object. Calls @p scenery at each step.
    /// Throws InputError (ResultsFolder).
    ResultsWriter(const std::string              &directory,
                  const std::function<Scenery()> &scenery);

    /// The steps that the run in the folder has whole, as Restart keeps them;
    /// the tables are cut to them. To be called before any step is written.
    /// Throws InputError (read_restart()), or if a table has become shorter.
    std::vector<StepResults>
    resume();

    /// Writes the last load step of @p results, which must have its rows. With
    /// the first one come scene.prm, the sections, the fields of the nodes and
    /// the tables' headers, and what an earlier run left goes. Throws
    /// InputError if that fails; the steps before are whole.
    void
    write_step(const Results &results);

    /// Writes the summary of @p results after all steps, which must have the
    /// checks of the last one, their goals and first failure; nothing if no
    /// step was solved.
    void
    write_outcome(const Results &results);

    /// The same at the end of the run: if all steps were solved, the restart
    /// becomes a word that says so.
    void
    write_end(const Results &results);

    /// Owned by the writer.
    const ResultsFolder &
    folder() const
    {
      return place;
    }

  private:
    /// Appends the rows of the last step to all tables; of the first step
    /// writes them anew.
    void
    write_tables(const Results &results);
    /// Of all contacts, as they are paired.
    void
    make_surfaces();
    /// The bodies, the contacts' surfaces, and the collections with them.
    void
    write_vtu_files(const StepResults &step);
    /// The summary and the restart.
    void
    write_standing(const Results &results);

    std::function<Scenery()> scenery;
    ResultsFolder            place;
    /// Of each contact; none without VTU files.
    std::vector<ContactSurface> surfaces;
    /// What is there so far.
    Restart standing;
  };
} // namespace lamella

#endif
