// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/section/corners.h>
#include <lamella/shape/corner_layers.h>

namespace lamella
{
  std::vector<dealii::Point<2>>
  corners_of(const Section &section)
  {
    const SectionMesh            &mesh = section.element().section_mesh();
    std::vector<dealii::Point<2>> corners;
    for (const unsigned int vertex : singular_corners(mesh))
      corners.push_back(mesh.mesh.get_vertices()[vertex]);
    return corners;
  }
} // namespace lamella
