// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_fields_table_h
#define lamella_report_fields_table_h

#include <lamella/solve/results.h>

#include <string>

namespace lamella
{
  /// `body,ply,x,y,z` and the field names.
  std::string
  fields_header();

  /// The line of a CSV file that belongs to fields_header(); plies are counted
  /// from 1 at the bottom. Numbers carry 15 digits.
  std::string
  fields_line(const FieldRow &row);

  /// @p value with 15 significant digits.
  std::string
  csv(const double value);
} // namespace lamella

#endif
