// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_tables_h
#define lamella_report_tables_h

#include <lamella/solve/results.h>

#include <map>
#include <string>

namespace lamella
{
  /// Name of a file in the folder of results -> text.
  using FileTexts = std::map<std::string, std::string>;

  /// The headers of probes.csv, history.csv, lines/NAME.csv, cuts/NAME.csv and
  /// contact_NAME.csv, with the ends of their lines: as fixed in doc/output.md.
  FileTexts
  table_headers(const Results &results);

  /// The rows of one load step of @p results in each of these.
  FileTexts
  table_rows(const Results &results, const StepResults &step);
} // namespace lamella

#endif
