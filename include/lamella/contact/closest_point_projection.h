// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_closest_point_projection_h
#define lamella_contact_closest_point_projection_h

#include <lamella/contact/mesh_surface.h>

#include <optional>

namespace lamella
{
  /// Returns the closest-point projection of @p x onto the map of a facet: the
  /// (s, t) with stationary distance,
  ///   X_,a . (x - X(s, t)) = 0.
  /// Newton's method from @p start with the matrix a_ab - r . X_,ab, the metric
  /// a_ab and r = x - X; the curvature is from differences of X_,a. The map is
  /// continued outside the unit square. Empty without convergence.
  std::optional<dealii::Point<2>>
  projection_on(const FacetMap         &map,
                const dealii::Point<3> &x,
                const dealii::Point<2> &start);

  /**
   * Returns the closest-point projection of @p x with outward normal @p n1 onto
   * @p surface: the nearest one within @p search_radius whose facet normal n_2
   * opposes n_1. @p opposed is the smallest cosine of the angle between n_1 and
   * -n_2. The normal of the hit is n_2, and its distance the gap g = n_2 . (x -
   * X_2), negative inside. The motion of the projection does not enter the
   * gradient, since X_,a . n_2 = 0: delta g = n_2 . (delta x - delta X_2).
   *
   * The projection remains on the facet of @p last, the previous one if known,
   * continued, up to 5 % of its length beyond a side with an adjacent facet,
   * which avoids jumps between facets with different normals. Beyond a side
   * without one there is no projection, except for 1 % along the body.
   */
  std::optional<SurfaceHit>
  closest_point_projection(const MeshSurface          &surface,
                           const dealii::Point<3>     &x,
                           const dealii::Tensor<1, 3> &n1,
                           const double                search_radius,
                           const std::optional<MeshSurface::FacetPoint> &last,
                           const double opposed = min_facing_cosine);

  /// Returns the closest-point projection onto a rigid obstacle: g = N . (x -
  /// p) for a plane, g = |r| - R for a cylinder, r = x - p normal to its axis.
  /// Empty on the axis.
  std::optional<SurfaceHit>
  closest_point_projection(const Obstacle             &obstacle,
                           const dealii::Point<3>     &x,
                           const dealii::Tensor<1, 3> &n1,
                           const double                search_radius);
} // namespace lamella

#endif
