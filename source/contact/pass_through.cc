// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/contact/contact.h>
#include <lamella/contact/mesh_surface.h>
#include <lamella/contact/pairing.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

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



    /// Vector across the axis to a point, and whether the axis is ahead there.
    struct Beside
    {
      Tensor<1, 3> r;
      bool         is_ahead;
    };



    Beside
    beside(const Obstacle &roller, const FacetMap &map, const Point<2> &st)
    {
      const auto         place = map(st);
      const Tensor<1, 3> r = roller.across_axis(place.position - roller.point);
      return {r, r * map.outward(place) < 0.};
    }



    /// Into how many parts a facet is divided each way.
    unsigned int
    parts_of(const FacetMap &map, const double longest)
    {
      constexpr double most = 40.;
      double           size = 0.;
      for (const Point<2> &st : {Point<2>(1., 0.), Point<2>(0., 1.)})
        size =
          std::max(size, map(st).position.distance(map({0., 0.}).position));
      return std::clamp(std::ceil(size / longest), 2., most);
    }



    /// The longest way from one of @p before to the same of @p after.
    double
    largest_displacement_between(const std::vector<SurfacePoint> &before,
                                 const std::vector<SurfacePoint> &after)
    {
      double longest = 0.;
      for (unsigned int k = 0; k < before.size(); ++k)
        longest =
          std::max(longest, before[k].position.distance(after[k].position));
      return longest;
    }



    /// The shallowest and the deepest of the cells below @p points.
    std::pair<double, double>
    depths(const std::vector<SurfacePoint> &points)
    {
      const auto [least, most] =
        std::minmax_element(points.begin(),
                            points.end(),
                            [](const SurfacePoint &a, const SurfacePoint &b) {
                              return a.depth < b.depth;
                            });
      return {least->depth, most->depth};
    }



    /// Whether @p point is behind @p surface, by more than cells are deep if it
    /// is to be @p deep_penetrations else by less, at most @p search_radius
    /// away.
    bool
    faces(const MeshSurface  &surface,
          const SurfacePoint &point,
          const double        search_radius,
          const bool          deep_penetrations)
    {
      const auto projection = closest_point_projection(
        surface, point.position, point.normal, search_radius, {});
      return projection &&
             exceeds_cell_depth(projection->distance,
                                point.depth,
                                surface.facets()[projection->facet].depth) ==
               deep_penetrations;
    }



    /// The nodes of both surfaces before and after, how far they move towards
    /// each other at most, and the shallowest and the deepest cell below them.
    struct Passage
    {
      Passage(const ContactSides &before, const ContactSides &after)
      {
        for (const bool second : {false, true})
          {
            were[second] = before.points(second);
            are[second]  = after.points(second);
            way += largest_displacement_between(were[second], are[second]);
            if (were[second].empty())
              continue;
            const auto [shallow, deep] = depths(were[second]);
            least                      = std::min(least, shallow);
            most                       = std::max(most, deep);
          }
      }

      std::array<std::vector<SurfacePoint>, 2> were, are;
      double way = 0., least = std::numeric_limits<double>::max(), most = 0.;
    };
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



  bool
  passes_through(const SurfaceAndRoller &before, const SurfaceAndRoller &after)
  {
    const Obstacle &roller = before.roller;
    if (roller.shape != Obstacle::Shape::cylinder)
      return false;
    for (unsigned int f = 0; f < before.surface.facets().size(); ++f)
      {
        const FacetMap &from = before.surface.facets()[f].map,
                       &to   = after.surface.facets()[f].map;
        const unsigned int n = parts_of(from, 0.5 * roller.radius);
        for (unsigned int i = 0; i <= n; ++i)
          for (unsigned int j = 0; j <= n; ++j)
            {
              const Point<2> st(double(i) / n, double(j) / n);
              const Beside   was = beside(roller, from, st),
                           is    = beside(after.roller, to, st);
              if (was.is_ahead && !is.is_ahead &&
                  distance_to_segment({}, Point<3>(was.r), Point<3>(is.r)) <
                    roller.radius)
                return true;
            }
      }
    return false;
  }



  bool
  may_pass_through(const ContactSides &before, const ContactSides &after)
  {
    const Passage passage(before, after);
    return passage.way >= passage.least;
  }



  bool
  passes_through(const ContactSides &before, const ContactSides &after)
  {
    const Passage passage(before, after);
    // Behind it may have been by that much, too.
    const double search_radius = passage.way + passage.most;
    for (const bool second : {false, true})
      for (unsigned int k = 0; k < passage.were[second].size(); ++k)
        if (faces(*after.surface(!second),
                  passage.are[second][k],
                  search_radius,
                  true) &&
            faces(*before.surface(!second),
                  passage.were[second][k],
                  search_radius,
                  false))
          return true;
    return false;
  }
} // namespace lamella
