// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_line_crossings_h
#define lamella_body_line_crossings_h

#include <deal.II/base/point.h>

#include <functional>
#include <vector>

namespace lamella
{
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
} // namespace lamella

#endif
