// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_line_crossings_h
#define lamella_body_line_crossings_h

#include <deal.II/base/point.h>

#include <functional>
#include <vector>

namespace lamella
{
  // Crossings of a line with elements, in the plane of the section (x, z):
  // sides of cells are edges, and the line is its projection. The bodies add
  // crossings along the axis.

  /// Adds to @p crossings the parameters t, any real numbers, at which the line
  /// a + t d meets an end of the straight edge from @p p to @p q or crosses it,
  /// within @p tolerance (a length). An edge on the line adds its two ends.
  /// @p d must not be zero, but need not have unit length. Edges that share a
  /// crossing each add it; merge_breaks() removes duplicates.
  void
  add_edge_crossings(const dealii::Point<2>     &p,
                     const dealii::Point<2>     &q,
                     const dealii::Point<2>     &a,
                     const dealii::Tensor<1, 2> &d,
                     const double                tolerance,
                     std::vector<double>        &crossings);

  /// Adds crossings with the curved edge @p x(s), s from 0 to 1: roots, to
  /// rounding, where the distance from the line changes its sign between five
  /// points of the edge. A curve that touches the line in between is missed.
  void
  add_curve_crossings(const std::function<dealii::Point<2>(const double)> &x,
                      const dealii::Point<2>                              &a,
                      const dealii::Tensor<1, 2>                          &d,
                      const double         tolerance,
                      std::vector<double> &crossings);

  /// Returns those of @p breaks in [0, 1], ascending, with 0 and 1: the pieces
  /// of a segment. Breaks closer than 1e-9 are merged.
  std::vector<double>
  merge_breaks(std::vector<double> breaks);
} // namespace lamella

#endif
