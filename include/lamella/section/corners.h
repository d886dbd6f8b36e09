// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_corners_h
#define lamella_section_corners_h

#include <lamella/section/section.h>

#include <vector>

namespace lamella
{
  /// Returns the positions (x, z) of the corners of @p section at which
  /// stresses are singular (see singular_corners()).
  std::vector<dealii::Point<2>>
  corners_of(const Section &section);
} // namespace lamella

#endif
