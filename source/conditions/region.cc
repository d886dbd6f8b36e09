// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/body/line_crossings.h>
#include <lamella/body/surface_topology.h>
#include <lamella/conditions/region.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  bool
  Region::covers(const std::string &side) const
  {
    return kind == Kind::surface && surface_names::covers(surface, side);
  }



  bool
  Region::covers_end(const bool at_start) const
  {
    return covers(surface_names::end_name(at_start));
  }



  double
  distance_to_segment(const Point<3> &x,
                      const Point<3> &begin,
                      const Point<3> &end)
  {
    const Tensor<1, 3> along  = end - begin;
    const double       square = along.norm_square(),
                 t            = square > 0. ?
                                  std::clamp((x - begin) * along / square, 0., 1.) :
                                  0.;
    return (x - begin - t * along).norm();
  }



  namespace
  {
    std::string
    in_words(const Point<3> &x, const int digits)
    {
      return "(" + to_text(x[0], digits) + ", " + to_text(x[1], digits) + ", " +
             to_text(x[2], digits) + ")";
    }



    /// The digits that a text needs to tell @p x from the corners of @p box in
    /// each component in which they differ; as few as six.
    int
    reported_digits(const Point<3> &x, const std::pair<Point<3>, Point<3>> &box)
    {
      constexpr int least = 6, all = 17;
      for (int digits = least; digits < all; ++digits)
        {
          bool tells = true;
          for (unsigned int c = 0; c < 3; ++c)
            for (const double end : {box.first[c], box.second[c]})
              tells = tells && (x[c] == end ||
                                to_text(x[c], digits) != to_text(end, digits));
          if (tells)
            return digits;
        }
      return all;
    }
  } // namespace



  bool
  Region::has_point_at(const Point<3> &x, const double near) const
  {
    if (kind == Kind::line)
      return distance_to_segment(x, at[0], at[1]) < near;
    return kind == Kind::point &&
           std::any_of(at.begin(), at.end(), [&](const Point<3> &point) {
             return x.distance(point) < near;
           });
  }



  bool
  Region::is_several_surfaces() const
  {
    return kind == Kind::surface && surface_names::is_compound_surface(surface);
  }



  std::vector<std::vector<Location>>
  locate_in_plies(const Body                  &body,
                  const std::vector<Point<3>> &points,
                  const std::string           &path)
  {
    std::vector<std::vector<Location>> found = body.locate(points);
    for (unsigned int i = 0; i < points.size(); ++i)
      if (found[i].empty())
        {
          const auto box    = body.bounding_box().get_boundary_points();
          const int  digits = reported_digits(points[i], box);
          throw InputError(path,
                           "",
                           "conditions.point-outside-body: the point " +
                             in_words(points[i], digits) + " is not in body '" +
                             body.name() + "', which extends from " +
                             in_words(box.first, digits) + " to " +
                             in_words(box.second, digits),
                           "Move the point into the body (scene coordinates).");
        }
    return found;
  }



  std::vector<Location>
  locate_all(const Body                  &body,
             const std::vector<Point<3>> &points,
             const std::string           &path)
  {
    std::vector<Location> locations;
    for (const std::vector<Location> &sides :
         locate_in_plies(body, points, path))
      locations.push_back(sides.front());
    return locations;
  }



  void
  check_surface(const Body        &body,
                const std::string &surface,
                const std::string &path)
  {
    const std::vector<std::string> names = body.surfaces();
    if (std::find(names.begin(), names.end(), surface) == names.end())
      throw InputError(path,
                       "",
                       "conditions.unknown-surface: body '" + body.name() +
                         "' has no surface '" + surface + "'",
                       "Check the spelling: the most similar name is '" +
                         nearest_name(surface, names) + "'; the surfaces are " +
                         joined(names) + ".");
  }



  std::vector<Location>
  region_locations(const Body        &body,
                   const Region      &region,
                   const std::string &path)
  {
    switch (region.kind)
      {
        case Region::Kind::point:
          return locate_all(body, region.at, path);
        case Region::Kind::line:
          // The ends first: a segment that leaves the body has no crossings.
          locate_all(body, region.at, path);
          return locate_all(body,
                            line_points(body, region.at[0], region.at[1]),
                            path);
        case Region::Kind::body:
          return body.body_points();
        case Region::Kind::surface:
          check_surface(body, region.surface, path);
          return body.constraint_points(region.surface);
        default:
          Assert(false, ExcMessage("The region was never filled in."));
          return {};
      }
  }
} // namespace lamella
