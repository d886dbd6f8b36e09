// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/shape/curve_normals.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace lamella
{
  using namespace dealii;

  double
  EllipseProjection::parameter(const Point<2> &x) const
  {
    const Tensor<1, 2> d = x - center;
    if (a == b)
      return std::atan2(d[1], d[0]);
    // In the first quadrant, and back.
    const double p = std::abs(d[0]), q = std::abs(d[1]);
    const auto   f = [&](const double phi) {
      const double c = std::cos(phi), s = std::sin(phi);
      return std::make_pair((a * a - b * b) * s * c - a * p * s + b * q * c,
                            (a * a - b * b) * (c * c - s * s) - a * p * c -
                              b * q * s);
    };
    constexpr double quarter = 0.5 * numbers::PI;
    double           phi     = q == 0. ? 0. : quarter;
    if (p != 0. && q != 0.)
      phi = boost::math::tools::newton_raphson_iterate(
        f,
        std::atan2(a * q, b * p),
        0.,
        quarter,
        std::numeric_limits<double>::digits - 2);
    return std::copysign(d[0] < 0. ? numbers::PI - phi : phi, d[1]);
  }



  Point<2>
  EllipseProjection::point(const double phi) const
  {
    return {center[0] + a * std::cos(phi), center[1] + b * std::sin(phi)};
  }



  Tensor<1, 2>
  EllipseProjection::normal(const double phi) const
  {
    const Point<2> n(b * std::cos(phi), a * std::sin(phi));
    return n / n.norm();
  }



  namespace
  {
    // Of the angle between two sides that are one curve.
    constexpr double least_cosine = 0.866;



    /// The outward normal of the side @p f of @p cell, which is convex.
    template <typename Cell>
    Tensor<1, 2>
    outward_normal(const Cell &cell, const unsigned int f)
    {
      const Point<2>     a     = cell->face(f)->vertex(0);
      const Tensor<1, 2> along = cell->face(f)->vertex(1) - a;
      Tensor<1, 2>       normal({along[1], -along[0]});
      if (normal * (cell->center() - a) > 0.)
        normal *= -1.;
      return normal / normal.norm();
    }



    double
    cross(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }



    /// The s in [0, 1] at which (p - s e) and (n + s m) are parallel.
    std::vector<double>
    parallel_places(const Tensor<1, 2> &p,
                    const Tensor<1, 2> &e,
                    const Tensor<1, 2> &n,
                    const Tensor<1, 2> &m)
    {
      constexpr double rounding = arithmetic::rounding_of_results;
      const double     a = -cross(e, m), b = cross(p, m) - cross(e, n),
                   c = cross(p, n), discriminant = b * b - 4. * a * c;
      std::vector<double> found;
      if (discriminant < 0.)
        return found;
      // Without cancellation, and for the linear equation that it nearly is.
      const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
      for (const double s : {q != 0. ? c / q : 0., a != 0. ? q / a : -1.})
        if (s > -rounding && s < 1. + rounding)
          found.push_back(std::clamp(s, 0., 1.));
      return found;
    }
  } // namespace



  CurveNormals::CurveNormals(const SectionMesh              &section,
                             const std::vector<std::string> &names)
  {
    // Of each vertex the sides that meet there, and their ends.
    std::map<unsigned int, std::vector<std::pair<unsigned int, unsigned int>>>
      meeting;
    for (const auto &cell : section.mesh.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (const auto face = cell->face(f);
            face->at_boundary() &&
            std::count(names.begin(),
                       names.end(),
                       section.boundaries.at(face->boundary_id())) > 0)
          {
            const Tensor<1, 2> normal = outward_normal(cell, f);
            for (const unsigned int end : {0, 1})
              meeting[face->vertex_index(end)].emplace_back(sides.size(), end);
            sides.push_back(
              {{{face->vertex(0), face->vertex(1)}}, {{normal, normal}}});
          }
    const std::vector<Side> own = sides;
    for (const auto &[vertex, ends] : meeting)
      if (ends.size() == 2)
        {
          const Tensor<1, 2> a = own[ends[0].first].normals[0],
                             b = own[ends[1].first].normals[0];
          if (a * b > least_cosine)
            for (const auto &[side, end] : ends)
              sides[side].normals[end] = (a + b) / (a + b).norm();
        }
  }



  Tensor<1, 2>
  CurveNormals::at(const Point<2> &x) const
  {
    // An end counts where it is nearer by far than any projection of a normal.
    constexpr double by_far   = 0.9;
    double           smallest = std::numeric_limits<double>::max();
    Tensor<1, 2>     normal;
    const auto       consider =
      [&](const Side &side, const double s, const double factor) {
        const Point<2> projection =
          side.ends[0] + s * (side.ends[1] - side.ends[0]);
        if (const double distance = factor * x.distance(projection);
            distance < smallest)
          {
            smallest = distance;
            normal   = (1. - s) * side.normals[0] + s * side.normals[1];
          }
      };
    for (const Side &side : sides)
      {
        for (const double s :
             parallel_places(x - side.ends[0],
                             side.ends[1] - side.ends[0],
                             side.normals[0],
                             side.normals[1] - side.normals[0]))
          consider(side, s, by_far);
        for (const double s : {0., 1.})
          consider(side, s, 1.);
      }
    return normal / normal.norm();
  }
} // namespace lamella
