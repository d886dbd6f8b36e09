// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_box_points_h
#define lamella_recover_box_points_h

#include <lamella/body/body.h>

#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Weights (with sum 1) and points of a quadrature rule for a mean value.
  using BoxPoints = std::vector<std::pair<double, Location>>;

  /// Returns the corners of a box with center @p middle and lengths @p edges.
  std::vector<dealii::Point<3>>
  box_corners(const dealii::Point<3>     &middle,
              const dealii::Tensor<1, 3> &edges);

  /// Returns the quadrature points X_q and weights w_q of the mean of a field f
  /// over the box with the center @p middle and the edge lengths @p edges in
  /// @p body,
  ///   1/V int f dV = sum_q w_q f(X_q).
  /// If edges have zero length, the mean is over an area, a line or a point.
  /// Integrals over x, y and z are nested and divided at element sides into
  /// intervals, in skewed elements into four each. Each has p / 2 + 2 Gauss
  /// points for displacements of degree p. The result is one quadrature rule,
  /// or two, for the lower and the upper ply, if the box is flat or a point and
  /// lies in a ply interface. Throws InputError, which names the scene entry @p
  /// path, if a corner or a point is not in the body, or for more than 200,000
  /// points. Not collective.
  std::vector<BoxPoints>
  box_points(const Body                 &body,
             const dealii::Point<3>     &middle,
             const dealii::Tensor<1, 3> &edges,
             const std::string          &path);
} // namespace lamella

#endif
