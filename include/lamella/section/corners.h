// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_corners_h
#define lamella_section_corners_h

#include <lamella/section/section.h>

#include <vector>

namespace lamella
{
  /// Returns the positions (x, z) of the points of @p section with singular
  /// stresses: re-entrant corners, and ends of ply interfaces on the boundary.
  std::vector<dealii::Point<2>>
  corners_of(const Section &section);
} // namespace lamella

#endif
