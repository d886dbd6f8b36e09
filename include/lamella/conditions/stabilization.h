// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_stabilization_h
#define lamella_conditions_stabilization_h

#include <lamella/conditions/support.h>

#include <string>
#include <vector>

namespace lamella
{
  /// A spring to the ground in the displacement r(u) of a row: energy 1/2 k
  /// r(u)^2, force on the body -k r(u) r^T, stiffness k r^T r of rank one
  /// (SpringTerm). It is condensed and reduced like any other row.
  struct Spring
  {
    /// Row r of the DoFs of one body [length]; compressed.
    LinearFunctional row;
    /// Stiffness k [force / length].
    double stiffness = 0.;
    /// Stabilization::share of the spring, dimensionless.
    double share = 0.;
    /// Description of the rigid motion that it resists.
    std::string motion;
  };

  /// Stiffness of springs for bodies that only contact holds in some rigid
  /// motions, as a share (such as 1e-6; 0: no springs) of the body's axial
  /// stiffness. The result is free of spring forces: the solution is repeated
  /// from the previous state until they vanish (the proximal point method,
  /// doc/theory/contact.md).
  struct Stabilization
  {
    double share = 0.;
  };

  /// Returns the centroid of the surface that @p points represent.
  dealii::Point<3>
  centroid_of(const std::vector<SurfacePoint> &points);

  /// Returns the corners of @p surface of @p body: all points furthest from its
  /// centroid (mirror images are treated alike), and if there is only one,
  /// those furthest from it, too.
  std::vector<SurfacePoint>
  farthest_points(const Body &body, const std::string &surface);

  /**
   * Returns one spring for each rigid motion of @p body, number @p index, that
   * @p rows leave free, acting on
   *   r(u) = 4 / n sum_p q(X_p) . u(X_p),
   * with the n corners X_p of both ends (points furthest from the end's
   * centroid), and motions q orthonormal in that product. The stiffness is
   * @p stabilization.share times E A / L (normal modulus and area of the start,
   * distance of the ends).
   *
   * If an end has one furthest point only, those furthest from it are added, to
   * resist rotation. The factor 4 / n makes springs independent of the number
   * of corners. Orthonormal motions make springs independent of each other.
   *
   * Returns none if @p stabilization.share is zero or the rows hold the body.
   * @p rows of other bodies are ignored.
   */
  std::vector<Spring>
  stabilizing_springs(const Body                              &body,
                      const unsigned int                       index,
                      const std::vector<PrescribedFunctional> &rows,
                      const Stabilization                     &stabilization);
} // namespace lamella

#endif
