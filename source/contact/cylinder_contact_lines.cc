// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/contact/cylinder_contact_lines.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

// Contact of a beam with a circular cylinder along material lines. On each line
// the distance from the cylinder's axis is minimized at every move:
// 1. samples on all facets of the line bracket the minimum;
// 2. Newton's method on r . X_,t = 0 finds it, also slightly past a side;
// 3. the previous facet is kept while it is as near, against jumps.
// The force then acts along the normal of the cylinder through that point
// (closest-point projection onto the axis).
// At the minimum, r . X_,t = 0, so the gap |r| - R is stationary in t and its
// gradient is the normal r / |r| at the material point.
namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Share of a facet's length allowed past a side with a neighbor.
    constexpr double past_the_side = 0.05;



    // Coordinate of @p x along the axis of @p roller.
    double
    station_of(const Obstacle &roller, const Point<3> &x)
    {
      return (x - roller.point) * roller.direction;
    }



    // Distance of a point of a facet from the axis of @p roller.
    double
    distance(const Obstacle &roller, const FacetMap &map, const Point<2> &st)
    {
      return roller.across_axis(map(st).position - roller.point).norm();
    }



    /// Returns t of the stationary distance from the axis of @p roller on the
    /// line s = @p start[0] of @p map, from t = @p start[1] on: r . X_,t = 0,
    /// by Newton's method with X_,tt from differences. Empty without a minimum.
    std::optional<double>
    nearest_on(const FacetMap &map, const Obstacle &roller, Point<2> start)
    {
      constexpr unsigned int max_iterations = 30;
      constexpr double       step           = arithmetic::same_in_element;
      for (unsigned int k = 0; k < max_iterations; ++k)
        {
          const auto         place   = map(start);
          const Tensor<1, 3> r       = roller.across_axis(place.position -
                                                    roller.point),
                             tangent = roller.across_axis(place.d_t),
                             bend    = (map({start[0], start[1] + step}).d_t -
                                     map({start[0], start[1] - step}).d_t) /
                                    (2. * step);
          const double slope = tangent * tangent + r * bend;
          if (slope <= 0.)
            return {};
          const double change = -(r * tangent) / slope;
          start[1] += change;
          if (!(std::abs(start[1]) < 10.))
            return {};
          if (std::abs(change) < arithmetic::rounding_of_sums)
            return start[1];
        }
      return {};
    }



    /// Returns it on @p facet, or past a side with a neighbor by a small share.
    std::optional<double>
    nearest_on(const MeshSurface::Facet &facet,
               const Obstacle           &roller,
               const Point<2>           &start)
    {
      const auto   t      = nearest_on(facet.map, roller, start);
      const double before = facet.has_neighbor[2] ? past_the_side : 0.,
                   behind = facet.has_neighbor[3] ? past_the_side : 0.;
      if (t && *t >= -before && *t <= 1. + behind)
        return t;
      return {};
    }
  } // namespace



  // Facets at a station of the axis, in material coordinates, linear in s.
  CylinderContactLines::Line
  CylinderContactLines::line_at(const MeshSurface &surface,
                                const Obstacle    &roller,
                                const double       station)
  {
    // Tolerance over a facet's width.
    constexpr double same = arithmetic::same_in_element;
    Line             line;
    // A line between two adjacent facets takes one of them.
    std::vector<Point<3>> middles;
    for (unsigned int f = 0; f < surface.facets().size(); ++f)
      {
        const FacetMap &map  = surface.facets()[f].map;
        const double    from = station_of(roller, map({0., 0.5}).position),
                     to      = station_of(roller, map({1., 0.5}).position);
        if (std::abs(to - from) == 0.)
          continue;
        const double s = (station - from) / (to - from);
        if (s < -same || s > 1. + same)
          continue;
        const double   inside = std::min(1., std::max(0., s));
        const Point<3> middle = map({inside, 0.5}).position;
        if (std::any_of(middles.begin(), middles.end(), [&](const auto &other) {
              return other.distance(middle) < same * std::abs(to - from);
            }))
          continue;
        middles.push_back(middle);
        line.push_back({f, inside});
      }
    return line;
  }



  CylinderContactLines::CylinderContactLines(const MeshSurface &surface,
                                             const Obstacle    &roller,
                                             ContactInterface  &interface)
  {
    // Nearest row of each station, rounded to a unit far below node distances.
    const double unit = arithmetic::decimal_tolerance * surface.body().size();
    std::map<long, unsigned int> nearest;
    const auto                   far = [&](const unsigned int k) {
      return roller.across_axis(place_of(interface.points[k]) - roller.point)
        .norm();
    };
    for (unsigned int k = 0; k < interface.rows.size(); ++k)
      {
        const long at =
          std::lround(station_of(roller, place_of(interface.points[k])) / unit);
        const auto [known, is_new] = nearest.emplace(at, k);
        if (!is_new && far(k) < far(known->second))
          known->second = k;
      }
    ContactInterface kept = interface;
    kept.rows.clear();
    kept.points.clear();
    kept.first.weights.clear();
    for (const auto &[at, k] : nearest)
      {
        kept.rows.push_back(interface.rows[k]);
        kept.points.push_back(interface.points[k]);
        kept.first.weights.push_back(interface.first.weights[k]);
        lines.push_back(line_at(
          surface, roller, station_of(roller, place_of(interface.points[k]))));
      }
    // A line has no area for a pressure.
    kept.surface = nullptr;
    interface    = std::move(kept);
  }



  // Global minimum by samples, then local minimum by Newton's method.
  MeshSurface::FacetPoint
  CylinderContactLines::nearest_point_on_line(
    const Line                    &line,
    const MeshSurface             &now,
    const Obstacle                &roller,
    const MeshSurface::FacetPoint &last)
  {
    constexpr unsigned int  samples  = 8;
    MeshSurface::FacetPoint best     = last;
    double                  smallest = std::numeric_limits<double>::max();
    const auto try_place = [&](const unsigned int facet, const Point<2> &st) {
      const double here = distance(roller, now.facets()[facet].map, st);
      if (here >= smallest)
        return;
      smallest = here;
      best     = {facet, st};
    };
    for (const auto &[facet, s] : line)
      for (unsigned int i = 0; i <= samples; ++i)
        try_place(facet, {s, double(i) / samples});
    // A sample on a side belongs to both facets.
    const double sampled = smallest * (1. + arithmetic::same_value);
    for (const auto &[facet, s] : line)
      {
        const FacetMap &map = now.facets()[facet].map;
        const bool      was = facet == last.facet;
        for (const double t :
             {was ? last.st[1] : 0., best.facet == facet ? best.st[1] : 1.})
          if (was || distance(roller, map, {s, t}) <= sampled)
            if (const auto found =
                  nearest_on(now.facets()[facet], roller, {s, t}))
              {
                // The point stays on its facet while that is as near.
                if (was && distance(roller, map, {s, *found}) <= sampled)
                  return {facet, {s, *found}};
                try_place(facet, {s, *found});
              }
      }
    return best;
  }



  // Called by every move, so that gaps are those of the nearest points.
  void
  CylinderContactLines::follow(const MeshSurface     &now,
                               const Obstacle        &roller,
                               std::vector<GapPoint> &points) const
  {
    for (unsigned int k = 0; k < points.size(); ++k)
      points[k].slave =
        nearest_point_on_line(lines[k], now, roller, points[k].slave);
  }



  // Curvature ratio from the gap of the surface over that of its tangent plane,
  // sqrt(R^2 + s^2) - R, at distances s of one to two node spacings.
  double
  CylinderContactLines::curvature(const Obstacle              &roller,
                                  const MeshSurface           &surface,
                                  const MeshSurface           &now,
                                  const std::vector<Point<3>> &places)
  {
    constexpr unsigned int samples = 24;
    double                 largest = 0.;
    for (const Point<3> &place : places)
      {
        const Line line = line_at(surface, roller, station_of(roller, place));
        if (line.empty())
          continue;
        const auto [facet, st] = nearest_point_on_line(
          line, now, roller, {line.front().facet, {line.front().s, 0.}});
        const MeshSurface::Facet &at   = now.facets()[facet];
        const auto                here = at.map(st);
        const double              spacing =
          at.map({st[0], 1.}).position.distance(at.map({st[0], 0.}).position) /
          at.side.degree_t;
        // Gap over that of a straight surface, before and behind.
        std::array<double, 2> left{{1., 1.}};
        for (const auto &[other, s] : line)
          for (unsigned int i = 0; i <= samples; ++i)
            {
              const Point<3> x =
                now.facets()[other].map({s, double(i) / samples}).position;
              const Tensor<1, 3> way = roller.across_axis(x - here.position);
              if (way.norm() < spacing || way.norm() > 2. * spacing)
                continue;
              double &share = left[way * here.d_t > 0.];
              share         = std::min(
                share,
                (roller.across_axis(x - roller.point).norm() - roller.radius) /
                  (std::hypot(roller.radius, way.norm()) - roller.radius));
            }
        largest = std::max(largest, 1. - 0.5 * (left[0] + left[1]));
      }
    return largest;
  }



  // Rows on one line are those whose distance is normal to the axis.
  ContactArc
  contact_arc(const ContactInterface          &interface,
              const std::vector<unsigned int> &active)
  {
    const Obstacle &roller = *interface.obstacle;
    // Distance of rows @p k and @p j on one line along the body, else none.
    const auto apart = [&](const unsigned int j,
                           const unsigned int k) -> std::optional<double> {
      const Tensor<1, 3> way =
        place_of(interface.points[k]) - place_of(interface.points[j]);
      if (j == k || std::abs(way * roller.direction) >
                      arithmetic::decimal_tolerance * way.norm())
        return {};
      return way.norm();
    };
    ContactArc arc;
    for (const unsigned int j : active)
      {
        double nearest = std::numeric_limits<double>::max();
        for (unsigned int k = 0; k < interface.points.size(); ++k)
          nearest = std::min(nearest, apart(j, k).value_or(nearest));
        if (nearest < std::numeric_limits<double>::max())
          arc.spacing = std::max(arc.spacing, nearest);
        for (const unsigned int k : active)
          arc.length = std::max(arc.length, apart(j, k).value_or(0.));
      }
    return arc;
  }



  // Deepest point of all lines with the axis on the outer side (r . n < 0).
  std::optional<CylinderPenetration>
  CylinderContactLines::deepest_in(const Obstacle    &roller,
                                   const MeshSurface &surface,
                                   const MeshSurface &now)
  {
    const double   unit = arithmetic::decimal_tolerance * surface.body().size();
    std::set<long> stations;
    for (const MeshSurface::GridNode &node : surface.grid_nodes())
      stations.insert(std::lround(station_of(roller, node.position) / unit));
    std::optional<CylinderPenetration> deepest;
    for (const long station : stations)
      {
        const Line line = line_at(surface, roller, station * unit);
        if (line.empty())
          continue;
        const auto at = nearest_point_on_line(
          line, now, roller, {line.front().facet, {line.front().s, 0.}});
        const FacetMap    &map   = now.facets()[at.facet].map;
        const auto         place = map(at.st);
        const Tensor<1, 3> r =
          roller.across_axis(place.position - roller.point);
        const double depth = roller.radius - r.norm();
        if (r * map.outward(place) < 0. &&
            depth > (deepest ? deepest->depth : 0.))
          deepest =
            CylinderPenetration{surface.facets()[at.facet].map(at.st).position,
                                depth};
      }
    return deepest;
  }
} // namespace lamella
