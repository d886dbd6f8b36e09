// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_line_crossings_h
#define lamella_body_line_crossings_h

#include <deal.II/base/point.h>

#include <vector>

namespace lamella
{
  /// Adds the parameters t at which the line a + t d of a section's plane
  /// passes the ends of the edge from @p p to @p q or crosses it; what is
  /// closer than @p tolerance (a length) touches.
  void
  add_edge_crossings(const dealii::Point<2>     &p,
                     const dealii::Point<2>     &q,
                     const dealii::Point<2>     &a,
                     const dealii::Tensor<1, 2> &d,
                     const double                tolerance,
                     std::vector<double>        &crossings);

  /// Those of @p breaks in [0, 1], ascending, once each, and 0 and 1.
  std::vector<double>
  tidy_breaks(std::vector<double> breaks);
} // namespace lamella

#endif
