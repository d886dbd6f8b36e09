// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/contact/foot.h>
#include <lamella/contact/sunk_end.h>

#include <cmath>

namespace lamella
{
  // Below the cosine of any two normals.
  constexpr double whatever_it_faces = -2.;

  std::optional<SunkEnd>
  deepest_node(const ContactSides &sides,
               const double        reach,
               const bool          of_ends)
  {
    std::optional<SunkEnd> deepest;
    for (const bool second : {false, true})
      {
        const MeshSurface &other = *sides.surface(!second);
        for (const SurfacePoint &point :
             of_ends ? sides.end_points(second) : sides.points(second))
          {
            const auto foot_of = [&](const double opposed) {
              return find_foot(
                other, point.position, point.normal, reach, {}, opposed);
            };
            const auto foot = foot_of(edge_faces_from);
            // Where another place is nearer that it does not face it is beside
            // the body, and the foot is on the far side.
            if (!foot || std::abs(foot_of(whatever_it_faces)->distance) <
                           std::abs(foot->distance))
              continue;
            if (-foot->distance > (deepest ? deepest->depth : 0.))
              deepest = {second,
                         -foot->distance,
                         other.facets()[foot->facet].depth,
                         {foot->facet, foot->st}};
          }
      }
    return deepest;
  }
} // namespace lamella
