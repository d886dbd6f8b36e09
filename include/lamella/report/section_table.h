// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_section_table_h
#define lamella_report_section_table_h

#include <lamella/shape/section_mesh.h>

#include <string>

namespace lamella
{
  /**
   * The mesh of a section for pictures, as CSV: a line a cell with its number,
   * ply (from 1), material and angle, then for its four sides,
   * counter-clockwise, the names of the boundaries that they lie on (empty
   * inside) and their points `x z;x z;...`: both ends, and seven between where
   * the side is curved. Lengths are the scene's, in the section's own axes x
   * (across) and z (up); the angle is that of the fibre, in degrees. Only sides
   * on the boundary are drawn curved.
   */
  std::string
  section_table(const SectionMesh &section);

  /// Writes section_table() into sections/@p name.csv of the existing folder
  /// @p directory. Throws InputError if it cannot.
  void
  write_section(const std::string &directory,
                const std::string &name,
                const SectionMesh &section);
} // namespace lamella

#endif
