// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_box_points_h
#define lamella_recover_box_points_h

#include <lamella/body/body.h>

#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Points of a body with weights that sum to 1. The mean of f is sum w f(X).
  using BoxPoints = std::vector<std::pair<double, Location>>;

  /// Returns the corners of the box around @p middle with the @p edges.
  std::vector<dealii::Point<3>>
  box_corners(const dealii::Point<3>     &middle,
              const dealii::Tensor<1, 3> &edges);

  /**
   * Returns the quadrature points of the mean over a box in @p body,
   *   1/V int f dV = sum_q w_q f(X_q).
   * A box without thickness is averaged over its area, its length, or at its
   * point. Integrals are iterated over x, y and z. Each is split where its
   * lines pass from element to element (Body::line_breaks()), so kinks and
   * jumps at ply interfaces lie between pieces. A piece has p / 2 + 2 Gauss
   * points along displacements of degree p (exact to degree p + 2). Pieces of
   * skewed elements are divided into four; the quadrature error at element
   * sides that cross a piece remains. A box without thickness in a ply
   * interface, or a point there, has two lists, the lower ply first. Throws
   * InputError, under the path @p path, if a corner or a point is not in the
   * body, or for more than 200,000 points. Not collective.
   */
  std::vector<BoxPoints>
  box_points(const Body                 &body,
             const dealii::Point<3>     &middle,
             const dealii::Tensor<1, 3> &edges,
             const std::string          &path);
} // namespace lamella

#endif
