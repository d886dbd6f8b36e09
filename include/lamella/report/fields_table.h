// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_fields_table_h
#define lamella_report_fields_table_h

#include <lamella/recover/results.h>

#include <string>

namespace lamella
{
  /// Returns the common columns of probes, lines and cuts, `body,ply,x,y,z` and
  /// field_names(), without an end of line.
  std::string
  fields_header();

  /// Returns a line for the columns fields_header(), without an end of line;
  /// plies count from 1.
  std::string
  fields_line(const FieldRow &row);

  /// Returns @p value with at most 15 significant digits, in any locale.
  std::string
  csv(const double value);
} // namespace lamella

#endif
