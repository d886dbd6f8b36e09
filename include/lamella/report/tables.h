// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_tables_h
#define lamella_report_tables_h

#include <lamella/recover/results.h>

#include <map>
#include <string>

namespace lamella
{
  /// Name of a file in the folder of results, as in `lines/NAME.csv` -> text.
  using FileTexts = std::map<std::string, std::string>;

  /// The headers of probes.csv, history.csv, lines/NAME.csv, cuts/NAME.csv and
  /// contact_NAME.csv, with the ends of their lines: as fixed in doc/output.md.
  /// They depend on the names in @p results alone, so they are the same for all
  /// load steps. Columns:
  ///   probes   step, probe, and those of fields_header()
  ///   lines    s (arc length), step, line, fields_header()
  ///   cuts     step, cut, cell, i, j, fields_header()
  ///   contacts step, both points, normal, area, initial_gap, gap, force,
  ///            pressure (force over area), active (1 where it touches)
  ///   history  step, load_factor, then of all supports and contacts the force
  ///            and of all probes the displacement, three components each
  FileTexts
  table_headers(const Results &results);

  /// The rows of @p step, one of the load steps of @p results, in each of
  /// these, to be appended to what is there. Files without a row in this step
  /// may be missing. A probe on a ply interface has a row a ply, and its
  /// displacement in history.csv is that of the first.
  FileTexts
  table_rows(const Results &results, const StepResults &step);

  /// The text of failure.csv: the load factors beyond the load steps at which
  /// the first failure of @p results, which must have been found, was looked
  /// for, ascending; load_factor, the smallest reserve_factor, and the forces
  /// and displacements of history.csv.
  std::string
  failure_table(const Results &results);
} // namespace lamella

#endif
