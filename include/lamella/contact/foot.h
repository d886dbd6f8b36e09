// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_foot_h
#define lamella_contact_foot_h

#include <lamella/contact/mesh_surface.h>

#include <optional>

namespace lamella
{
  /**
   * The foot of @p x on a facet: the (s, t) at which the distance from @p x to
   * the facet's map is stationary,
   *   X_,a . (x - X(s, t)) = 0,
   * by Newton's method from @p start with the matrix a_ab - r . X_,ab, a_ab the
   * metric and r = x - X (the curvature from differences of X_,a, so that the
   * method converges fast and its limit is exact). The map is continued outside
   * of the unit square. Nothing if the iteration does not settle.
   */
  std::optional<dealii::Point<2>>
  foot_on(const FacetMap         &map,
          const dealii::Point<3> &x,
          const dealii::Point<2> &start);

  /**
   * The place of @p surface that the point @p x with the outward normal @p n1
   * faces by closest-point projection: the nearest foot, at most @p reach away,
   * at which the facet's own normal n_2 opposes n_1 to @p opposed, the cosine
   * of the angle between n_1 and -n_2, or better.
   * The hit's normal is n_2 and its distance the gap
   *   g = n_2 . (x - X_2),
   * negative where x is inside. Its gradient has no part of the foot's own
   * motion, since X_,a . n_2 = 0: delta g = n_2 . (delta x - delta X_2).
   *
   * @p last is where the foot was, if it is known. It stays on that facet,
   * continued, until it is 5 % of its length beyond a side at which another
   * facet goes on, and so it does not jump between two facets whose normals
   * differ. Where none goes on a foot beyond the side is none, but for 1 %
   * along the body; nothing beyond where that starts or ends.
   */
  std::optional<SurfaceHit>
  find_foot(const MeshSurface                            &surface,
            const dealii::Point<3>                       &x,
            const dealii::Tensor<1, 3>                   &n1,
            const double                                  reach,
            const std::optional<MeshSurface::FacetPlace> &last,
            const double opposed = faces_from_60);

  /// The same on a rigid obstacle where it stands: of a plane g = N . (x - p),
  /// of a cylinder g = |r| - R with r = x - p across its axis. None on the axis
  /// itself.
  std::optional<SurfaceHit>
  find_foot(const Obstacle             &obstacle,
            const dealii::Point<3>     &x,
            const dealii::Tensor<1, 3> &n1,
            const double                reach);
} // namespace lamella

#endif
