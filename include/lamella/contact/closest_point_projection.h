// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_closest_point_projection_h
#define lamella_contact_closest_point_projection_h

#include <lamella/contact/mesh_surface.h>

#include <optional>

namespace lamella
{
  /// Returns the closest-point projection of @p x onto a facet with the map
  /// X(s, t): the point (s, t) with stationary distance,
  ///   X_,a . (x - X(s, t)) = 0,   a = s, t.
  /// Newton's method from @p start uses the matrix a_ab - r . X_,ab with the
  /// metric a_ab and r = x - X; X_,ab is from differences of X_,a. The map is
  /// continued outside the unit square. Empty if it does not converge.
  std::optional<dealii::Point<2>>
  projection_on(const FacetMap         &map,
                const dealii::Point<3> &x,
                const dealii::Point<2> &start);

  /// Returns the closest-point projection of @p x, with outward normal @p n1,
  /// onto @p surface: the nearest one within @p search_radius whose facet
  /// normal n_2 opposes n_1. @p opposed is the smallest permitted cosine of the
  /// angle between n_1 and -n_2. In the result the normal is n_2, and the
  /// distance is the gap g = n_2 . (x - X_2), negative for penetration. The
  /// motion of the projection does not enter the gradient, since X_,a . n_2 =
  /// 0: delta g = n_2 . (delta x - delta X_2).
  ///
  /// If the previous projection @p last is known, its facet is used again as
  /// long as the projection is at most 5 % of the facet length outside a side
  /// with an adjacent facet. Beyond a side without an adjacent facet there is
  /// no projection, except within 1 % in the direction of the beam axis.
  std::optional<SurfaceHit>
  closest_point_projection(const MeshSurface          &surface,
                           const dealii::Point<3>     &x,
                           const dealii::Tensor<1, 3> &n1,
                           const double                search_radius,
                           const std::optional<MeshSurface::FacetPoint> &last,
                           const double opposed = min_facing_cosine);

  /// Returns the closest-point projection onto a rigid obstacle. The gap is g =
  /// N . (x - p) for a plane with normal N through p, and g = |r| - R for a
  /// cylinder of radius R, with the part r of x - p normal to its axis. Empty
  /// on the axis.
  std::optional<SurfaceHit>
  closest_point_projection(const Obstacle             &obstacle,
                           const dealii::Point<3>     &x,
                           const dealii::Tensor<1, 3> &n1,
                           const double                search_radius);
} // namespace lamella

#endif
