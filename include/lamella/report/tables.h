// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_tables_h
#define lamella_report_tables_h

#include <lamella/recover/results.h>

#include <map>
#include <string>

namespace lamella
{
  /// Contents of result files by file name, such as `lines/NAME.csv`.
  using FileTexts = std::map<std::string, std::string>;

  /// Returns the header lines of all tables (doc/reference/output.md) for the
  /// probes, lines, cuts, contacts and supports named in @p results. Columns:
  ///   probes   step, probe, fields_header()
  ///   lines    s (arc length), step, line, fields_header()
  ///   cuts     step, cut, cell, i, j, fields_header()
  ///   contacts step, both points, normal, area, initial_gap, gap, force,
  ///            pressure (force over area), active (1 if in contact)
  ///   history  step, load_factor, then three components of the force of each
  ///            support and contact and of the displacement of each probe
  FileTexts
  table_headers(const Results &results);

  /// Returns the lines of all tables for the load step @p step of @p results,
  /// without headers. A probe on a ply interface has one line per ply.
  FileTexts
  table_rows(const Results &results, const StepResults &step);

  /// Returns the content of failure.csv, a line for each load factor at which
  /// the search for first ply failure solved the scene: smallest reserve
  /// factor, forces and displacements as in history.csv.
  std::string
  failure_table(const Results &results);
} // namespace lamella

#endif
