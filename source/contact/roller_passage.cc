// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/contact/roller_passage.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// From the axis to a place, across it, and whether the axis is ahead
    /// there.
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



    /// How near the chord from @p a to @p b comes to the origin.
    double
    nearest_of_chord(const Tensor<1, 3> &a, const Tensor<1, 3> &b)
    {
      const Tensor<1, 3> d      = b - a;
      const double       length = d * d;
      const double t = length > 0. ? std::clamp(-(a * d) / length, 0., 1.) : 0.;
      return (a + t * d).norm();
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
  } // namespace



  bool
  goes_through(const BesideRoller &before, const BesideRoller &after)
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
                  nearest_of_chord(was.r, is.r) < roller.radius)
                return true;
            }
      }
    return false;
  }
} // namespace lamella
