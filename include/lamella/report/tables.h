// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_tables_h
#define lamella_report_tables_h

#include <lamella/recover/results.h>

#include <map>
#include <string>

namespace lamella
{
  /// Text of each file in the folder of results, by name, as `lines/NAME.csv`.
  using FileTexts = std::map<std::string, std::string>;

  /**
   * Returns the headers of these files, with their ends of line
   * (doc/reference/output.md), from the names in @p results:
   *   probes   step, probe, fields_header()
   *   lines    s (arc length), step, line, fields_header()
   *   cuts     step, cut, cell, i, j, fields_header()
   *   contacts step, both points, normal, area, initial_gap, gap, force,
   *            pressure (force over area), active (1 if in contact)
   *   history  step, load_factor, then three components of the force of each
   *            support and contact and of the displacement of each probe
   */
  FileTexts
  table_headers(const Results &results);

  /// Returns the rows of @p step of @p results for each of these files. A probe
  /// on a ply interface has a row per ply; its displacement in history.csv is
  /// that of the first.
  FileTexts
  table_rows(const Results &results, const StepResults &step);

  /// Returns failure.csv: the load factors that the search for first failure of
  /// @p results tried, ascending, with load_factor, the smallest
  /// reserve_factor, and the forces and displacements of history.csv.
  std::string
  failure_table(const Results &results);
} // namespace lamella

#endif
