// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_corners_h
#define lamella_section_corners_h

#include <lamella/section/section.h>

namespace lamella
{
  /// How many places @p section has at which stresses have no limit
  /// (singular_corners()).
  unsigned int
  n_corners(const Section &section);
} // namespace lamella

#endif
