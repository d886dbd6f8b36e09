// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_corners_h
#define lamella_section_corners_h

#include <lamella/section/section.h>

#include <vector>

namespace lamella
{
  /// Returns the points (x, z) of @p section with singular stresses.
  std::vector<dealii::Point<2>>
  corners_of(const Section &section);
} // namespace lamella

#endif
