// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_section_table_h
#define lamella_report_section_table_h

#include <lamella/shape/section_mesh.h>

#include <string>

namespace lamella
{
  /// Returns the mesh of a section for pictures, as CSV. Each cell has a line
  /// with its number, ply (from 1), material and angle of the fibers [degrees].
  /// Its four sides follow, counter-clockwise, with their boundary names (empty
  /// inside) and points `x z;x z;...`: both ends, and seven between if a
  /// boundary side is curved. Lengths are the scene's, in section axes.
  std::string
  section_table(const SectionMesh &section);

  /// Writes section_table() into sections/@p name.csv of the existing folder
  /// @p directory. Throws InputError on failure.
  void
  write_section(const std::string &directory,
                const std::string &name,
                const SectionMesh &section);
} // namespace lamella

#endif
