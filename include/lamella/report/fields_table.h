// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_fields_table_h
#define lamella_report_fields_table_h

#include <lamella/recover/results.h>

#include <string>

namespace lamella
{
  /// `body,ply,x,y,z` and the field names (field_names()), without the end of a
  /// line: the columns that probes, lines and cuts have in common.
  std::string
  fields_header();

  /// The line of a CSV file that belongs to fields_header(); plies are counted
  /// from 1 at the bottom. Numbers carry 15 digits; no end of a line.
  std::string
  fields_line(const FieldRow &row);

  /// @p value with 15 significant digits, as short as these allow, whatever the
  /// language of the system.
  std::string
  csv(const double value);
} // namespace lamella

#endif
