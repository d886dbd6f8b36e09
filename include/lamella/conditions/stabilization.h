// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_stabilization_h
#define lamella_conditions_stabilization_h

#include <lamella/conditions/support.h>

#include <string>
#include <vector>

namespace lamella
{
  /// A spring between a body and the ground that acts on the displacement r(u),
  /// a linear functional of the DoFs: energy 1/2 k r(u)^2, stiffness k r^T r.
  struct Spring
  {
    /// Functional r of the DoFs of one body [length].
    LinearFunctional row;
    /// Stiffness k [force / length].
    double stiffness = 0.;
    /// Stiffness k relative to E A / L of the body (Stabilization::share).
    double share = 0.;
    /// Description of the rigid motion that the spring resists.
    std::string motion;
  };

  /// Stiffness of stabilizing springs as a fraction `share` of the axial
  /// stiffness E A / L of the body (such as 1e-6; 0: no springs), for bodies
  /// with rigid motions that only contact constrains. The solution is repeated
  /// with relaxed springs until their forces vanish (proximal point method,
  /// doc/theory/contact.md).
  struct Stabilization
  {
    double share = 0.;
  };

  /// Returns the centroid of the surface that @p points represent.
  dealii::Point<3>
  centroid_of(const std::vector<SurfacePoint> &points);

  /// Returns the points of @p surface of @p body that are furthest from its
  /// centroid; if this is a single point, also those furthest from that point.
  std::vector<SurfacePoint>
  farthest_points(const Body &body, const std::string &surface);

  /// Returns one spring for each rigid motion of @p body (which has the index
  /// @p index) that the constraints @p rows leave free. The spring acts on
  ///   r(u) = 4 / n sum_p q(X_p) . u(X_p),
  /// with the n corners X_p of both ends (farthest_points()) and rigid motions
  /// q that are orthonormal in the inner product 4 / n sum_p q(X_p) . q'(X_p).
  /// The stiffness is @p stabilization.share times E A / L (normal modulus and
  /// area of the start section, distance of the ends).
  std::vector<Spring>
  stabilizing_springs(const Body                              &body,
                      const unsigned int                       index,
                      const std::vector<PrescribedFunctional> &rows,
                      const Stabilization                     &stabilization);
} // namespace lamella

#endif
