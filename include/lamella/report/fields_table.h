// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_fields_table_h
#define lamella_report_fields_table_h

#include <lamella/body/body.h>

#include <string>
#include <vector>

namespace lamella
{
  /// ux ... uz, exx ... gyz, sxx ... syz, s11 ... s23, jump.
  const std::vector<std::string> &
  field_names();

  /// The values of @p sample in the order of field_names(). Strains and
  /// stresses are printed in the order of the CSV files, exx, eyy, ezz, gxy,
  /// gxz, gyz, which is that of Eq. 4.
  std::vector<double>
  field_values(const FieldSample &sample);

  /// `body,ply,x,y,z` and the field names.
  std::string
  fields_header();

  /// The line of a CSV file that belongs to fields_header(); plies are counted
  /// from 1 at the bottom. Numbers carry 15 digits.
  std::string
  fields_line(const std::string      &body,
              const unsigned int      ply,
              const dealii::Point<3> &position,
              const FieldSample      &sample);

  /// @p value with 15 significant digits.
  std::string
  csv(const double value);
} // namespace lamella

#endif
