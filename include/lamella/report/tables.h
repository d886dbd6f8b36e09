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
   * Returns the headers of probes.csv, history.csv, lines/NAME.csv,
   * cuts/NAME.csv and contact_NAME.csv, with their ends of line
   * (doc/reference/output.md). They depend on the names in @p results alone.
   * Columns: probes   step, probe, fields_header() lines    s (arc length),
   * step, line, fields_header() cuts     step, cut, cell, i, j, fields_header()
   *   contacts step, both points, normal, area, initial_gap, gap, force,
   *            pressure (force over area), active (1 where it touches)
   *   history  step, load_factor, then three components of the force of each
   *            support and contact and of the displacement of each probe
   */
  FileTexts
  table_headers(const Results &results);

  /// Returns the rows of @p step of @p results for each of these files, to be
  /// appended. Files without a row may be missing. A probe on a ply interface
  /// has a row per ply; its displacement in history.csv is that of the first.
  FileTexts
  table_rows(const Results &results, const StepResults &step);

  /// Returns failure.csv: the load factors beyond the load steps that the
  /// search for first failure of @p results, which must have been found, tried,
  /// ascending, with load_factor, the smallest reserve_factor, and the forces
  /// and displacements of history.csv.
  std::string
  failure_table(const Results &results);
} // namespace lamella

#endif
