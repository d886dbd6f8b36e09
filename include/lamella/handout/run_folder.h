// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_handout_run_folder_h
#define lamella_handout_run_folder_h

#include <lamella/handout/csv_table.h>
#include <lamella/scene/scene_text.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * What a run left in its folder (doc/output.md), read. Only `summary.json`
   * and `scene.prm` must be there; of what else is missing the tables are
   * empty, as of a scene that did not ask for it.
   */
  class RunFolder
  {
  public:
    /// Reads the folder @p path. Throws InputError if there is none, if no run
    /// has left its results there, or if a file is not what a run writes.
    explicit RunFolder(const std::string &path);

    /// As it was given, without slashes at its end.
    const std::string path;
    /// summary.json, members in its order.
    const nlohmann::ordered_json summary;
    /// scene.prm as it stands there, and its entries.
    const std::string scene_text;
    const SceneText   scene;
    const CsvTable    probes, history, goals, passes, plies;

    /// contact_NAME.csv of the contact @p name, its last load step.
    CsvTable
    contact(const std::string &name) const;
    /// sections/NAME.csv, the mesh of the section @p name.
    CsvTable
    section_mesh(const std::string &name) const;
    /// sections/NAME.json, the section as a beam; null if there is none.
    nlohmann::ordered_json
    section_stiffness(const std::string &name) const;

    /// What the scene says of the entry @p entry; empty if nothing.
    std::string
    says(const std::string &entry) const;
    /// The names in the list @p entry of the scene: `Bodies`, say.
    std::vector<std::string>
    names(const std::string &entry) const;

    /// Labels of the scene's units: of "length", "force" or "stress"; empty in
    /// a scene without units.
    std::string
    unit(const std::string &kind) const;
    /// The same in brackets, and as the ending of a number (` mm`).
    std::string
    unit_in_brackets(const std::string &kind) const;
    std::string
    unit_behind(const std::string &kind) const;
    /// Of a moment: length times force.
    std::string
    moment_unit_in_brackets() const;
    /// In brackets the unit of a column of a table, or of a resultant: of `uz`,
    /// `sxy`, `fz`, `mx`, `x`, `pressure`, `width`. Empty where there is none.
    std::string
    unit_of_column(const std::string &name) const;
    /// The column as a formula with its unit.
    std::string
    with_unit(const std::string &column) const;

    /// The paths, relative to the folder, of its tables, in alphabetical order.
    std::vector<std::string>
    table_files() const;
    /// When summary.json was written, UTC.
    std::string
    date() const;
  };

  /// All bytes of the file @p path; empty if it cannot be read.
  std::string
  content_of(const std::string &path);

  /// The member @p name of the object @p json; an empty object if there is
  /// none.
  const nlohmann::ordered_json &
  member(const nlohmann::ordered_json &json, const std::string &name);

  /// The number of @p json, as HTML: see number(). A dash where there is none.
  std::string
  number(const nlohmann::ordered_json &json,
         const double                  scale  = 0.,
         const int                     digits = 5);

  /// A vector of @p json as `(x, y, z)`; components below 1e-9 of its length
  /// are shown as 0.
  std::string
  components(const nlohmann::ordered_json &json);
} // namespace lamella

#endif
