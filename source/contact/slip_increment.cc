// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/contact/slip_increment.h>

#include <cmath>

// Slip of a step from the change of the projections, objective by construction:
// both points of a pair move with their bodies, and only the distance of the
// projections on each surface counts (Wriggers, Computational Contact
// Mechanics, Springer 2006, Sec. 4.2). Tangents are convected. The same
// distance of points that face the other surface at one end of a step only is
// that of the two material points that face each other at the other end.
namespace lamella
{
  using namespace dealii;

  namespace
  {
    // cos 5 degrees.
    constexpr double along_y = 0.996;



    /// Returns tangents normal to @p n, the first one along @p along.
    Tangents
    tangents_along(const Tensor<1, 3> &along, const Tensor<1, 3> &n)
    {
      const Tensor<1, 3> normal = n / n.norm();
      Tensor<1, 3>       t1     = along - (along * normal) * normal;
      t1 /= t1.norm();
      return {{t1, cross_product_3d(normal, t1)}};
    }



    /// Returns the current position of @p place on @p surface.
    Point<3>
    position(const MeshSurface &surface, const MeshSurface::FacetPoint &place)
    {
      return surface.facets()[place.facet].map(place.st).position;
    }



    /// Returns the way on @p obstacle from the place of @p then to @p hit: on a
    /// roller the arc R alpha along the tangent at the hit.
    Tensor<1, 3>
    chord_on_surface(const Obstacle           &obstacle,
                     const SlipReferencePoint &then,
                     const SurfaceHit         &hit)
    {
      const Tensor<1, 3> way =
        (hit.position - obstacle.point) - then.on_obstacle;
      if (obstacle.shape == Obstacle::Shape::plane)
        return way;
      const Tensor<1, 3> &axis = obstacle.direction, &n = hit.normal;
      const double        angle =
        std::atan2(cross_product_3d(then.normal, n) * axis, then.normal * n);
      return (way * axis) * axis +
             (obstacle.radius * angle) * cross_product_3d(axis, n);
    }
  } // namespace



  Tangents
  tangents_of(const Tensor<1, 3> &n)
  {
    Tensor<1, 3> along;
    along[std::abs(n[1]) > along_y * n.norm() ? 0 : 1] = 1.;
    return tangents_along(along, n);
  }



  // Convection of t_1 with the facet map, then projection normal to n.
  Tangents
  convected_tangents(const FacetMap     &before,
                     const FacetMap     &now,
                     const Point<2>     &st,
                     const Tensor<1, 3> &n)
  {
    const FacetMap::Place place = before(st), moved = now(st);
    const Tensor<1, 3>    t1 = tangents_of(before.outward(place))[0];
    // Contravariant components, X_,a c_a = t_1, convected to x_,a c_a.
    SymmetricTensor<2, 2> metric;
    metric[0][0] = place.d_s * place.d_s;
    metric[0][1] = place.d_s * place.d_t;
    metric[1][1] = place.d_t * place.d_t;
    const Tensor<1, 2> c =
      invert(metric) * Tensor<1, 2>({place.d_s * t1, place.d_t * t1});
    return tangents_along(c[0] * moved.d_s + c[1] * moved.d_t, n);
  }



  // Places on an obstacle are stored relative to it, as it may move.
  SlipReferencePoint
  slip_reference_point(const ContactSides &sides,
                       const GapPoint     &point,
                       const MasterPoint  &at)
  {
    SlipReferencePoint held;
    held.point = point;
    if (sides.obstacle() != nullptr)
      {
        held.on_obstacle = at.hit.position - sides.obstacle()->point;
        held.normal      = at.hit.normal;
      }
    return held;
  }



  // s = P (way on the slave surface - way on the master surface).
  Tensor<1, 3>
  slip_increment_of(const ContactSides       &sides,
                    const bool                on_second,
                    const SlipReferencePoint &then,
                    const GapPoint           &now,
                    const MasterPoint        &at)
  {
    Tensor<1, 3> way = position(*sides.surface(on_second), now.slave) -
                       position(*sides.surface(on_second), then.point.slave);
    way -= sides.obstacle() != nullptr ?
             chord_on_surface(*sides.obstacle(), then, at.hit) :
             position(*sides.surface(!on_second), now.master) -
               position(*sides.surface(!on_second), then.point.master);
    return way - (way * at.normal) * at.normal;
  }



  Tensor<1, 3>
  slip_past_edge(const ContactSides       &sides,
                 const bool                on_second,
                 const SlipReferencePoint &then)
  {
    const MeshSurface &slave       = *sides.surface(on_second);
    const auto &[facet, st]        = then.point.slave;
    const MeshSurface::Facet &from = slave.facets()[facet];
    const Tensor<1, 3>        n    = slave.smooth_normal(from, st),
                       way         = (sides.obstacle() != nullptr ?
                                        sides.obstacle()->point + then.on_obstacle :
                                        position(*sides.surface(!on_second),
                                         then.point.master)) -
                             from.map(st).position;
    return way - (way * n) * n;
  }



  Tensor<1, 3>
  slip_from_past_edge(const ContactSides &began,
                      const ContactSides &sides,
                      const bool          on_second,
                      const GapPoint     &now,
                      const MasterPoint  &at)
  {
    const auto &[facet, st] = now.slave;
    const FacetMap &before  = began.surface(on_second)->facets()[facet].map,
                   &moved   = sides.surface(on_second)->facets()[facet].map;
    const Point<3> master =
      sides.obstacle() != nullptr ?
        at.hit.position + (began.obstacle()->point - sides.obstacle()->point) :
        position(*began.surface(!on_second), now.master);
    const Tensor<1, 3> way  = before(st).position - master;
    const Tangents     then = tangents_of(before.outward(before(st))),
                   t        = convected_tangents(before, moved, st, at.normal);
    return (way * then[0]) * t[0] + (way * then[1]) * t[1];
  }
} // namespace lamella
