// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_box_points_h
#define lamella_recover_box_points_h

#include <lamella/body/body.h>

#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Points X of a body with weights w, sum w = 1; sum w f(X) is a mean of f.
  using BoxPoints = std::vector<std::pair<double, Location>>;

  /// Returns the corners of the box with the center @p middle and the @p edges.
  std::vector<dealii::Point<3>>
  box_corners(const dealii::Point<3>     &middle,
              const dealii::Tensor<1, 3> &edges);

  /// Returns the quadrature points of the mean over a box in @p body,
  ///   1/V int f dV = sum_q w_q f(X_q).
  /// A flat box is averaged over its area, or over its length, or evaluated at
  /// its point. Integrals over x, y and z are nested and divided into intervals
  /// at element sides (Body::line_breaks()), so that fields are smooth within
  /// intervals. An interval has p / 2 + 2 Gauss points for displacements of
  /// degree p along it (exact to degree p + 2). In skewed elements, intervals
  /// are divided into four; a quadrature error remains at element sides that
  /// cross an interval. A flat box in a ply interface, or a point on an
  /// interface, has two lists of points, the lower ply first. Throws
  /// InputError, under the path @p path, if a corner or a point is not in the
  /// body, or for more than 200,000 points. Not collective.
  std::vector<BoxPoints>
  box_points(const Body                 &body,
             const dealii::Point<3>     &middle,
             const dealii::Tensor<1, 3> &edges,
             const std::string          &path);
} // namespace lamella

#endif
