// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_fields_table_h
#define lamella_report_fields_table_h

#include <lamella/recover/results.h>

#include <string>

namespace lamella
{
  /// Returns the CSV column names common to the tables of probes, lines and
  /// cuts: `body,ply,x,y,z` and field components (field_names()); no newline.
  std::string
  fields_header();

  /// Returns the values of @p row in the columns of fields_header(), without a
  /// newline; plies are numbered from 1.
  std::string
  fields_line(const FieldRow &row);

  /// Returns @p value with at most 15 significant digits, in any locale.
  std::string
  csv(const double value);
} // namespace lamella

#endif
