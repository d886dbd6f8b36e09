// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/contact/closest_point_projection.h>
#include <lamella/contact/end_penetration.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Below the cosine of any two normals.
    constexpr double whatever_it_faces = -2.;



    /// Returns the closest-point projection of @p point onto @p other, at most
    /// @p search_radius away. None if a place that @p point does not face is
    /// closer: the point is then beside the body.
    std::optional<SurfaceHit>
    nearest_projection(const MeshSurface  &other,
                       const SurfacePoint &point,
                       const double        search_radius)
    {
      const auto projection_of = [&](const double opposed) {
        return closest_point_projection(
          other, point.position, point.normal, search_radius, {}, opposed);
      };
      const auto projection = projection_of(min_facing_cosine_edge);
      if (!projection || std::abs(projection_of(whatever_it_faces)->distance) <
                           std::abs(projection->distance))
        return {};
      return projection;
    }



    /// Returns whether @p hit on @p other is at an end of that body, among
    /// whose end nodes @p ends are: flush ends penetrate like their faces.
    bool
    is_at_end(const MeshSurface               &other,
              const SurfaceHit                &hit,
              const std::vector<SurfacePoint> &ends)
    {
      const FacetMap    &map   = other.facets()[hit.facet].map;
      const Tensor<1, 3> along = map(hit.st).d_t;
      const double       across =
        (map({1., 1.}).position - map({0., 0.}).position).norm();
      return std::any_of(ends.begin(), ends.end(), [&](const auto &end) {
        const Tensor<1, 3> way = end.position - hit.position;
        return way.norm() <= across &&
               std::abs(way * along) <=
                 arithmetic::same_in_element * along.norm_square();
      });
    }
  } // namespace



  std::optional<EndPenetration>
  deepest_node(const ContactSides &paired,
               const ContactSides &now,
               const double        search_radius,
               const bool          of_ends)
  {
    std::optional<EndPenetration> deepest;
    for (const bool second : {false, true})
      {
        const MeshSurface &other = *paired.surface(!second),
                          &moved = *now.surface(!second);
        const auto nodes_of      = [&](const ContactSides &sides) {
          return of_ends ? sides.end_points(second) : sides.points(second);
        };
        const auto nodes = nodes_of(paired), are = nodes_of(now),
                   other_ends = paired.end_points(!second);
        for (unsigned int k = 0; k < nodes.size(); ++k)
          {
            const auto projection =
              nearest_projection(other, nodes[k], search_radius);
            if (!projection ||
                (of_ends && is_at_end(other, *projection, other_ends)))
              continue;
            const Tensor<1, 3> approach =
              (moved.facets()[projection->facet].map(projection->st).position -
               projection->position) -
              (are[k].position - nodes[k].position);
            const double depth =
              projection->normal * approach - projection->distance;
            if (depth > (deepest ? deepest->depth : 0.))
              deepest = {second,
                         depth,
                         other.facets()[projection->facet].depth,
                         {projection->facet, projection->st}};
          }
      }
    return deepest;
  }
} // namespace lamella
