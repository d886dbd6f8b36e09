// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_stabilization_h
#define lamella_conditions_stabilization_h

#include <lamella/conditions/support.h>

#include <string>
#include <vector>

namespace lamella
{
  /// A spring between a body and the ground that acts on a mean displacement
  /// r(u) of the body: energy 1/2 k r(u)^2, stiffness matrix k r^T r.
  struct Spring
  {
    /// Mean displacement r as a functional of the DoFs of the body [length].
    LinearFunctional row;
    /// Stiffness k [force / length].
    double stiffness = 0.;
    /// Ratio of k to the axial stiffness E A / L of the body.
    double share = 0.;
    /// Description of the rigid motion that the spring resists, for messages.
    std::string motion;
  };

  /// Parameter of stabilizing springs for bodies with rigid motions that only
  /// contact constrains. The solution is repeated with relaxed springs until
  /// their forces vanish (proximal point method, doc/theory/contact.md).
  struct Stabilization
  {
    /// Spring stiffness divided by E A / L of the body, such as 1e-6; 0: none.
    double share = 0.;
    /// For an obstacle under a given force (GuidedObstacle) the body that it
    /// presses, which gives E A / L; null for other bodies.
    const Body *pressed = nullptr;
  };

  /// Spring::motion of an obstacle under a given force.
  constexpr const char *motion_along_force = "translation along its Force";

  /// Returns the centroid of a surface: the mean of the positions of its nodes
  /// @p points, weighted by their tributary areas.
  dealii::Point<3>
  centroid_of(const std::vector<SurfacePoint> &points);

  /// Returns the nodes of the surface @p surface of @p body that are farthest
  /// from its centroid; if this is one node, also those farthest from it.
  std::vector<SurfacePoint>
  farthest_points(const Body &body, const std::string &surface);

  /// Returns one spring for each rigid motion of @p body (which has the index
  /// @p index) that the support constraints @p rows leave free. It acts on
  ///   r(u) = 4 / n sum_p q(X_p) . u(X_p),
  /// with the n corners X_p of both ends (farthest_points()) and rigid motions
  /// q that are orthonormal in the inner product 4 / n sum_p q(X_p) . q'(X_p).
  /// The stiffness is @p stabilization.share times E A / L (normal modulus and
  /// area of the start section, distance of the ends). A GuidedObstacle has one
  /// spring along its guide.
  std::vector<Spring>
  stabilizing_springs(const Body                              &body,
                      const unsigned int                       index,
                      const std::vector<PrescribedFunctional> &rows,
                      const Stabilization                     &stabilization);
} // namespace lamella

#endif
