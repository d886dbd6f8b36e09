// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_line_crossings_h
#define lamella_body_line_crossings_h

#include <deal.II/base/point.h>

#include <functional>
#include <vector>

namespace lamella
{
  class Body;

  // Intersections of a line a + t d with the edges of section cells, in the
  // plane (x, z) of the section.

  /// Adds to @p crossings the parameters t at which the line a + t d intersects
  /// the straight edge from @p p to @p q, within @p tolerance [length]. If the
  /// edge is on the line, its two ends are added. @p d must not be zero.
  /// Duplicates are possible (merge_breaks()).
  void
  add_edge_crossings(const dealii::Point<2>     &p,
                     const dealii::Point<2>     &q,
                     const dealii::Point<2>     &a,
                     const dealii::Tensor<1, 2> &d,
                     const double                tolerance,
                     std::vector<double>        &crossings);

  /// Adds to @p crossings the parameters t at which the line a + t d intersects
  /// the curved edge @p x(s), s in [0, 1], within @p tolerance [length]. Two
  /// intersections less than a quarter of the edge apart may both be missed.
  void
  add_curve_crossings(const std::function<dealii::Point<2>(const double)> &x,
                      const dealii::Point<2>                              &a,
                      const dealii::Tensor<1, 2>                          &d,
                      const double         tolerance,
                      std::vector<double> &crossings);

  /// Returns 0, 1 and the parameters @p breaks that are between them, in
  /// ascending order and without duplicates (within 1e-9).
  std::vector<double>
  merge_breaks(std::vector<double> breaks);

  /// Returns ordered points from @p from to @p to that determine the
  /// displacement of @p body on the segment: Body::line_degree() + 1
  /// Gauss-Lobatto points between successive Body::line_breaks().
  std::vector<dealii::Point<3>>
  line_points(const Body             &body,
              const dealii::Point<3> &from,
              const dealii::Point<3> &to);
} // namespace lamella

#endif
