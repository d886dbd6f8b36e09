// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_line_crossings_h
#define lamella_body_line_crossings_h

#include <deal.II/base/point.h>

#include <functional>
#include <vector>

namespace lamella
{
  // Crossings of a line with elements in the plane (x, z) of the section; the
  // bodies add those along the axis.

  /// Adds to @p crossings the parameters t at which the line a + t d meets an
  /// end of the straight edge from @p p to @p q or crosses it, within @p
  /// tolerance (a length). An edge on the line adds its two ends. @p d must not
  /// be zero. Shared crossings are repeated; merge_breaks() removes duplicates.
  void
  add_edge_crossings(const dealii::Point<2>     &p,
                     const dealii::Point<2>     &q,
                     const dealii::Point<2>     &a,
                     const dealii::Tensor<1, 2> &d,
                     const double                tolerance,
                     std::vector<double>        &crossings);

  /// Adds crossings with the curved edge @p x(s), s in [0, 1]: roots of the
  /// distance from the line between five points with a change of sign.
  void
  add_curve_crossings(const std::function<dealii::Point<2>(const double)> &x,
                      const dealii::Point<2>                              &a,
                      const dealii::Tensor<1, 2>                          &d,
                      const double         tolerance,
                      std::vector<double> &crossings);

  /// Returns the @p breaks in [0, 1], ascending, with 0 and 1, merged to 1e-9.
  std::vector<double>
  merge_breaks(std::vector<double> breaks);
} // namespace lamella

#endif
