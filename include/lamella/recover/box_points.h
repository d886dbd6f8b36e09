// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_box_points_h
#define lamella_recover_box_points_h

#include <lamella/body/body.h>

#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Points of a body with their weights, which sum to 1: of a function its
  /// mean is sum w f(X).
  using BoxPoints = std::vector<std::pair<double, Location>>;

  /// The eight corners of the box with the edges @p edges along the scene's
  /// axes around @p middle; of edges that are zero some of them coincide.
  std::vector<dealii::Point<3>>
  box_corners(const dealii::Point<3>     &middle,
              const dealii::Tensor<1, 3> &edges);

  /**
   * The points of the mean over a box in @p body,
   *   1/V int f dV = sum_q w_q f(X_q),
   * of a box without thickness over its area, its length, or at the point
   * itself. Integrals are iterated, x, then y, then z; each is cut where its
   * lines pass from element to element (Body::line_breaks()), so that kinks
   * and the jumps at ply interfaces are between pieces, and a piece has Gauss
   * points for the displacements' degree p along it: p / 2 + 2 of them, exact
   * to degree p + 2. Where elements are bricks along the box's edges the means
   * of displacements, strains and stresses are exact. Where they are askew
   * pieces are divided in four, and what is left is the rule's error at the
   * sides of elements that run through pieces.
   *
   * One list of points; two of a box without thickness in a ply interface, of
   * which the first is in the lower ply, or of a point there (one a ply).
   *
   * Throws InputError, under the path @p path, if a corner or one of the points
   * is not in the body, or for more than 200,000 points. Communicates nothing.
   */
  std::vector<BoxPoints>
  box_points(const Body                 &body,
             const dealii::Point<3>     &middle,
             const dealii::Tensor<1, 3> &edges,
             const std::string          &path);
} // namespace lamella

#endif
