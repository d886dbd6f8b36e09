// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_section_table_h
#define lamella_report_section_table_h

#include <lamella/shape/section_mesh.h>

#include <string>

namespace lamella
{
  /// Returns the mesh of a section as CSV for plots. Each cell has a line with
  /// number, ply (from 1), material and fiber angle [degrees], and a line for
  /// each of its four sides, counter-clockwise. The line of a side has the name
  /// of the boundary (empty inside) and points `x z;x z;...` in section axes:
  /// two ends, and seven points between them if the side is curved.
  std::string
  section_table(const SectionMesh &section);

  /// Writes section_table() to sections/NAME.csv in the folder @p directory.
  /// Throws InputError on failure.
  void
  write_section(const std::string &directory,
                const std::string &name,
                const SectionMesh &section);
} // namespace lamella

#endif
