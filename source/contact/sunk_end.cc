// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/contact/foot.h>
#include <lamella/contact/sunk_end.h>

namespace lamella
{
  std::optional<SunkEnd>
  deepest_end(const ContactSides &sides, const double reach)
  {
    std::optional<SunkEnd> deepest;
    for (const bool second : {false, true})
      {
        const MeshSurface &other = *sides.surface(!second);
        for (const SurfacePoint &point : sides.end_points(second))
          {
            const auto foot = find_foot(
              other, point.position, point.normal, reach, {}, edge_faces_from);
            if (!foot)
              continue;
            if (-foot->distance > (deepest ? deepest->depth : 0.))
              deepest = {second,
                         -foot->distance,
                         other.facets()[foot->facet].depth};
          }
      }
    return deepest;
  }
} // namespace lamella
