// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/contact/cylinder_contact_lines.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>

// Contact of a beam with a circular cylinder along material lines. On each line
// the distance from the cylinder's axis is minimized at every move:
// 1. samples on all facets of the line bracket the minimum;
// 2. the method TOMS 748 finds r . t = 0, t the tangent normal to the
//    continuous normal of the surface.
// The force then acts along the normal of the cylinder through that point
// (closest-point projection onto the axis).
// Slopes of elements differ at their nodes, by the shear angle below a line
// load. With the tangents X_,t of the elements, a node that is farther from the
// roller than both its sides would have two nearest points, and the contact
// point would alternate between them.
// At r . X_,t = 0 the gap |r| - R is stationary in t, and its gradient is the
// normal r / |r| at the material point; here to the difference of the tangents.
namespace lamella
{
  using namespace dealii;

  namespace
  {
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



    // Slope of half the squared distance of the point @p at from the axis of @p
    // roller along t, on the surface @p now with its continuous normals.
    double
    slope(const Obstacle                &roller,
          const MeshSurface             &now,
          const MeshSurface::FacetPoint &at)
    {
      const MeshSurface::Facet &facet = now.facets()[at.facet];
      const auto                place = facet.map(at.st);
      const Tensor<1, 3>        n     = now.smooth_normal(facet, at.st);
      return roller.across_axis(place.position - roller.point) *
             (place.d_t - (place.d_t * n) * n);
    }



    // Point between @p low and @p high on one facet where slope() is zero.
    // Empty unless it changes from - to +.
    std::optional<MeshSurface::FacetPoint>
    nearest_between(const Obstacle               &roller,
                    const MeshSurface            &now,
                    const MeshSurface::FacetPoint low,
                    const MeshSurface::FacetPoint high)
    {
      const double at_low  = slope(roller, now, low),
                   at_high = slope(roller, now, high);
      if (at_low > 0. || at_high < 0. || at_low == at_high)
        return {};
      MeshSurface::FacetPoint at             = low;
      std::uintmax_t          max_iterations = 60;
      const auto              root = boost::math::tools::toms748_solve(
        [&](const double t) {
          at.st[1] = t;
          return slope(roller, now, at);
        },
        low.st[1],
        high.st[1],
        at_low,
        at_high,
        boost::math::tools::eps_tolerance<double>(),
        max_iterations);
      at.st[1] = 0.5 * (root.first + root.second);
      return at;
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



  // Samples, then zeros of the slope beside those that are about as near as the
  // nearest.
  MeshSurface::FacetPoint
  CylinderContactLines::nearest_point_on_line(const Line        &line,
                                              const MeshSurface &now,
                                              const Obstacle    &roller)
  {
    constexpr unsigned int  samples     = 8;
    constexpr double        about_equal = 1.05;
    MeshSurface::FacetPoint best{};
    double                  smallest = std::numeric_limits<double>::max();
    std::vector<double>     sampled;
    const auto sample = [&](const Piece &on, const unsigned int i) {
      return MeshSurface::FacetPoint{on.facet, {on.s, double(i) / samples}};
    };
    const auto try_point = [&](const MeshSurface::FacetPoint &at) {
      const double here = distance(roller, now.facets()[at.facet].map, at.st);
      if (here < smallest)
        best = at;
      smallest = std::min(smallest, here);
      return here;
    };
    for (const Piece &on : line)
      for (unsigned int i = 0; i <= samples; ++i)
        sampled.push_back(try_point(sample(on, i)));
    const double near = about_equal * smallest;
    // Zeros replace the nearest sample.
    smallest = std::numeric_limits<double>::max();
    for (unsigned int k = 0; k < line.size(); ++k)
      for (unsigned int i = 0; i < samples; ++i)
        if (const double *ends = &sampled[k * (samples + 1) + i];
            std::min(ends[0], ends[1]) <= near)
          if (const auto found = nearest_between(
                roller, now, sample(line[k], i), sample(line[k], i + 1)))
            try_point(*found);
    return best;
  }



  // Called by every evaluation, so that gaps are those of the nearest points.
  void
  CylinderContactLines::follow(const MeshSurface     &now,
                               const Obstacle        &roller,
                               std::vector<GapPoint> &points) const
  {
    for (unsigned int k = 0; k < points.size(); ++k)
      points[k].slave = nearest_point_on_line(lines[k], now, roller);
  }



  // Curvature ratio from the gap of the surface over that of its tangent plane,
  // sqrt(R^2 + s^2) - R, at distances s of one to two node spacings.
  double
  CylinderContactLines::curvature(const Obstacle    &roller,
                                  const MeshSurface &surface,
                                  const MeshSurface &now,
                                  const Point<3>    &place)
  {
    constexpr unsigned int samples = 24;
    const Line line = line_at(surface, roller, station_of(roller, place));
    if (line.empty())
      return 0.;
    const auto [facet, st]         = nearest_point_on_line(line, now, roller);
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
          share =
            std::min(share,
                     (roller.across_axis(x - roller.point).norm() -
                      roller.radius) /
                       (std::hypot(roller.radius, way.norm()) - roller.radius));
        }
    return std::max(0., 1. - 0.5 * (left[0] + left[1]));
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
        const auto         at    = nearest_point_on_line(line, now, roller);
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
