// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_corners_h
#define lamella_section_corners_h

#include <lamella/section/section.h>

#include <vector>

namespace lamella
{
  /// Returns the places of @p section (x, z) at which stresses have no limit
  /// (singular_corners()).
  std::vector<dealii::Point<2>>
  corners_of(const Section &section);
} // namespace lamella

#endif
