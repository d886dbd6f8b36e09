// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_polygon_h
#define lamella_contact_polygon_h

#include <deal.II/base/point.h>
#include <deal.II/base/quadrature.h>

#include <functional>
#include <vector>

namespace lamella
{
  /// Corners of a convex polygon, counterclockwise, with coordinates in a plane
  /// [length] or in the unit square of a surface facet. It may be empty.
  using Polygon = std::vector<dealii::Point<2>>;

  /// Returns the area: 0 below three corners, negative if clockwise.
  double
  area(const Polygon &polygon);

  /// Returns the centroid of @p polygon, whose area must not vanish.
  dealii::Point<2>
  centroid(const Polygon &polygon);

  /// Returns the intersection of @p polygon and @p window, both convex and
  /// counterclockwise (Sutherland-Hodgman clipping). It may be empty.
  Polygon
  clipped(const Polygon &polygon, const Polygon &window);

  /// Returns the subset of the convex @p polygon on which @p height,
  /// interpolated linearly along the sides, is not negative. Called with
  /// -height, the function returns the complement, with bitwise the same edge.
  Polygon
  part_above(const Polygon                                         &polygon,
             const std::function<double(const dealii::Point<2> &)> &height);

  /// Returns a quadrature rule on the triangle (0, 0), (1, 0), (0, 1), exact
  /// for polynomials of degree @p degree, with positive weights that sum to
  /// 1/2: Witherden and Vincent's up to degree 13, above it Gauss points of the
  /// square collapsed onto the triangle. Its cache is not thread-safe.
  const dealii::Quadrature<2> &
  triangle_rule(const unsigned int degree);
} // namespace lamella

#endif
