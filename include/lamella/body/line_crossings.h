// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_line_crossings_h
#define lamella_body_line_crossings_h

#include <deal.II/base/point.h>

#include <functional>
#include <vector>

namespace lamella
{
  // Where a line through a body passes from element to element, seen in the
  // plane of the section (x, z): there sides of cells are edges, and the line
  // is its projection. Along the axis the bodies do the rest.

  /**
   * Adds to @p crossings the parameters t at which the line a + t d passes the
   * ends of the straight edge from @p p to @p q or crosses it; what is closer
   * than @p tolerance (a length) touches. An edge that lies on the line gives
   * its two ends.
   *
   * The line has no ends here: t may be any number. @p d, which need not have
   * unit length, must not be zero. The same crossing comes once from each edge
   * that has it; tidy_breaks() sorts that out.
   */
  void
  add_edge_crossings(const dealii::Point<2>     &p,
                     const dealii::Point<2>     &q,
                     const dealii::Point<2>     &a,
                     const dealii::Tensor<1, 2> &d,
                     const double                tolerance,
                     std::vector<double>        &crossings);

  /**
   * The same for the curved edge @p x(s), s from 0 to 1: where the distance
   * from the line changes its sign between five of its points, the root to
   * rounding. A curve that touches the line in between is not seen.
   */
  void
  add_curve_crossings(const std::function<dealii::Point<2>(const double)> &x,
                      const dealii::Point<2>                              &a,
                      const dealii::Tensor<1, 2>                          &d,
                      const double         tolerance,
                      std::vector<double> &crossings);

  /// Those of @p breaks in [0, 1], ascending, once each, and 0 and 1: the
  /// pieces of a segment. What is closer together than 1e-9 is one break.
  std::vector<double>
  tidy_breaks(std::vector<double> breaks);
} // namespace lamella

#endif
