// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_stabilization_h
#define lamella_conditions_stabilization_h

#include <lamella/conditions/support.h>

#include <string>
#include <vector>

namespace lamella
{
  /// A spring to the ground in the displacement r(u) of a row: energy 1/2 k
  /// r(u)^2, force -k r(u) r^T, stiffness k r^T r of rank one (SpringTerm).
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

  /// Stiffness of springs for bodies that only contact constrains in some rigid
  /// motions, as a share (such as 1e-6; 0: none) of the axial stiffness. Spring
  /// forces vanish by iteration from the previous state (proximal point method,
  /// doc/theory/contact.md).
  struct Stabilization
  {
    double share = 0.;
  };

  /// Returns the centroid of the surface that @p points represent.
  dealii::Point<3>
  centroid_of(const std::vector<SurfacePoint> &points);

  /// Returns the corners of @p surface of @p body: all points furthest from its
  /// centroid, and if there is only one, those furthest from it, too.
  std::vector<SurfacePoint>
  farthest_points(const Body &body, const std::string &surface);

  /**
   * Returns one spring for each rigid motion of @p body, number @p index, that
   * @p rows leave free, acting on
   *   r(u) = 4 / n sum_p q(X_p) . u(X_p),
   * with the n corners X_p of both ends (farthest_points()), and motions q
   * orthonormal in that product, which makes springs independent of each other
   * and of the number of corners. The stiffness is @p stabilization.share times
   * E A / L (normal modulus and area of the start, distance of the ends). None
   * if the share is zero or the rows constrain the body.
   */
  std::vector<Spring>
  stabilizing_springs(const Body                              &body,
                      const unsigned int                       index,
                      const std::vector<PrescribedFunctional> &rows,
                      const Stabilization                     &stabilization);
} // namespace lamella

#endif
