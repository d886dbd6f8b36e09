// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_closest_point_projection_h
#define lamella_contact_closest_point_projection_h

#include <lamella/contact/mesh_surface.h>

#include <optional>

namespace lamella
{
  /// Returns the closest-point projection X_2 of @p x onto @p surface: the
  /// nearest one within @p search_radius whose facet normal n_2 is opposite to
  /// @p n1, the outward normal at x. @p opposed is the smallest permitted
  /// cosine of the angle between n1 and -n_2. The result has n_2 as normal and
  /// the gap g = n_2 . (x - X_2) as distance, negative for penetration. The
  /// motion of X_2 on the facet does not enter the gradient, as tangents are
  /// normal to n_2: delta g = n_2 . (delta x - delta X_2). The result is empty
  /// if there is no projection.
  ///
  /// If the previous projection @p last is known, its facet is kept while the
  /// projection lies on it, or beyond a side with an adjacent facet by at most
  /// 5 % of the facet length. Beyond a side without an adjacent facet there is
  /// no projection, except up to 1 % of this length along the beam axis.
  std::optional<SurfaceHit>
  closest_point_projection(const MeshSurface          &surface,
                           const dealii::Point<3>     &x,
                           const dealii::Tensor<1, 3> &n1,
                           const double                search_radius,
                           const std::optional<MeshSurface::FacetPoint> &last,
                           const double opposed = min_facing_cosine);

  /// Returns the closest-point projection of @p x, with outward normal @p n1,
  /// onto @p obstacle within @p search_radius. The gap is g = N . (x - p) for a
  /// plane with normal N through p, and g = |r| - R for a cylinder of radius R,
  /// with the component r of x - p normal to its axis. Empty if r = 0.
  std::optional<SurfaceHit>
  closest_point_projection(const Obstacle             &obstacle,
                           const dealii::Point<3>     &x,
                           const dealii::Tensor<1, 3> &n1,
                           const double                search_radius);
} // namespace lamella

#endif
