// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/section/corners.h>
#include <lamella/shape/corner_layers.h>

namespace lamella
{
  unsigned int
  n_corners(const Section &section)
  {
    return singular_corners(section.element().section_mesh()).size();
  }
} // namespace lamella
