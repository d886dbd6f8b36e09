// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_polygon_h
#define lamella_contact_polygon_h

#include <deal.II/base/point.h>
#include <deal.II/base/quadrature.h>

#include <functional>
#include <vector>

namespace lamella
{
  /// The corners of a polygon in a plane, a chord plane [length] or the unit
  /// square of a facet, counterclockwise;
  /// convex in all that follows. Empty: nothing.
  using Polygon = std::vector<dealii::Point<2>>;

  /// Its area, 0 of fewer than three corners; negative if the corners run
  /// clockwise. A fan of triangles from the first corner, so digits are those
  /// of the polygon and not of its distance to the origin.
  double
  area(const Polygon &polygon);

  /// Its centroid; the area must not vanish.
  dealii::Point<2>
  centroid(const Polygon &polygon);

  /// The part of @p polygon inside of @p window, both convex and
  /// counterclockwise (Sutherland and Hodgman). Empty if they have nothing in
  /// common. At most as many corners as both have together.
  Polygon
  clipped(const Polygon &polygon, const Polygon &window);

  /// The part of @p polygon, convex, on which @p height is at least 0, taken as
  /// linear along the polygon's sides. What is left is where the height is at
  /// most 0: the two have an edge in common, to the last bit.
  Polygon
  part_above(const Polygon                                         &polygon,
             const std::function<double(const dealii::Point<2> &)> &height);

  /**
   * A rule on the triangle (0, 0), (1, 0), (0, 1) that integrates polynomials
   * of @p degree exactly; all weights are positive. Weights sum to 1/2. Rules
   * of Witherden and Vincent up to degree 13, above it Gauss points of the
   * square collapsed onto the triangle. Each is made once and kept; the list of
   * them is not guarded against several threads.
   */
  const dealii::Quadrature<2> &
  triangle_rule(const unsigned int degree);
} // namespace lamella

#endif
