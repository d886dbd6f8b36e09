// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/contact/mesh_surface.h>

#include <cmath>

// Closest-point projection by Newton's method on X_,a . (x - X) = 0 with the
// metric and curvature of the facet (Wriggers, Computational Contact Mechanics,
// Springer 2006, Sec. 4.1; Konyukhov and Schweizerhof, Computational Contact
// Mechanics, Springer 2013). The search uses boxes of growing size.
namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Shares of a facet's length that a projection may be beyond a side: with a
    // neighbor, and at the rim along a body. Strips of one width have points on
    // each other's rims, which bending moves across them.
    constexpr double beyond = 0.05, beyond_rim = 0.01;



    /// Returns a_ab - r . X_,ab at @p st, r = x - X: the Hessian of |r|^2 / 2
    /// by (s, t).
    Tensor<2, 2>
    projection_matrix(const FacetMap        &map,
                      const Point<2>        &st,
                      const FacetMap::Place &place,
                      const Tensor<1, 3>    &r)
    {
      const auto   second = map.curvature(st);
      Tensor<2, 2> matrix;
      matrix[0][0] = place.d_s * place.d_s - r * second.d_ss;
      matrix[0][1] = matrix[1][0] = place.d_s * place.d_t - r * second.d_st;
      matrix[1][1]                = place.d_t * place.d_t - r * second.d_tt;
      return matrix;
    }



    /// Returns true if @p st is on the facet, or, if @p or_near, at most as far
    /// beyond a side as a projection may be.
    bool
    is_on(const MeshSurface::Facet &facet,
          const Point<2>           &st,
          const bool                or_near)
    {
      const auto room = [&](const unsigned int side) {
        if (!or_near || (facet.at_body_end[side] && !facet.has_neighbor[side]))
          return arithmetic::same_in_element;
        return facet.has_neighbor[side] ? beyond : beyond_rim;
      };
      return st[0] >= -room(0) && st[0] <= 1. + room(1) && st[1] >= -room(2) &&
             st[1] <= 1. + room(3);
    }



    /// Returns the place @p st of facet @p number as projection of @p x with
    /// the normal @p n1; nothing if the normals are not opposed.
    std::optional<SurfaceHit>
    hit_at(const MeshSurface  &surface,
           const unsigned int  number,
           const Point<2>     &st,
           const Point<3>     &x,
           const Tensor<1, 3> &n1,
           const double        opposed)
    {
      const MeshSurface::Facet &facet = surface.facets()[number];
      const auto                place = facet.map(st);
      SurfaceHit                hit;
      hit.position = place.position;
      hit.normal   = surface.outward_normal(facet, place);
      hit.distance = hit.normal * (x - hit.position);
      hit.facet    = number;
      hit.st       = st;
      if (n1 * hit.normal > -opposed)
        return {};
      return hit;
    }



    /// Returns the closest-point projection of @p x onto a facet with the map
    /// X(s, t): the point (s, t) with stationary distance,
    ///   X_,a . (x - X(s, t)) = 0,   a = s, t,
    /// with X_,a the derivative of X. Newton's method from @p start uses the
    /// matrix X_,a . X_,b - (x - X) . X_,ab; X_,ab is from differences of X_,a.
    /// The map is continued outside the unit square. Empty if not converged.
    // Newton's method, quadratic for facets of any curvature; one step if
    // affine.
    std::optional<Point<2>>
    projection_on(const FacetMap &map, const Point<3> &x, const Point<2> &start)
    {
      constexpr unsigned int max_iterations = 30;
      Point<2>               st             = start;
      for (unsigned int k = 0; k < max_iterations; ++k)
        {
          const auto         place = map(st);
          const Tensor<1, 3> r     = x - place.position;
          const Tensor<1, 2> step =
            invert(projection_matrix(map, st, place, r)) *
            Tensor<1, 2>({place.d_s * r, place.d_t * r});
          st += step;
          // The test also ends the iteration for NaN.
          if (!(st.norm() < 10.))
            return {};
          if (map.is_affine() || step.norm() < arithmetic::rounding_of_sums)
            return st;
        }
      return {};
    }



    /// Returns the nearest projection of @p x on facets within @p
    /// search_radius. Between two convex facets it lies on the continuation of
    /// either.
    /// Projections on facets have precedence over those on their continuations.
    std::optional<SurfaceHit>
    nearest_projection(const MeshSurface  &surface,
                       const Point<3>     &x,
                       const Tensor<1, 3> &n1,
                       const double        search_radius,
                       const double        opposed)
    {
      const Tensor<1, 3> around({search_radius, search_radius, search_radius});
      std::optional<SurfaceHit> on, continued;
      for (const unsigned int number :
           surface.facets_near({x - around, x + around}))
        {
          const MeshSurface::Facet &facet = surface.facets()[number];
          const auto st = projection_on(facet.map, x, {0.5, 0.5});
          if (!st || !is_on(facet, *st, true))
            continue;
          auto &nearest = is_on(facet, *st, false) ? on : continued;
          if (const auto hit = hit_at(surface, number, *st, x, n1, opposed);
              hit && std::abs(hit->distance) <=
                       (nearest ? std::abs(nearest->distance) : search_radius))
            nearest = hit;
        }
      return on ? on : continued;
    }
  } // namespace



  std::optional<SurfaceHit>
  closest_point_projection(const MeshSurface  &surface,
                           const Point<3>     &x,
                           const Tensor<1, 3> &n1,
                           const double        search_radius,
                           const std::optional<MeshSurface::FacetPoint> &last,
                           const double opposed)
  {
    if (last)
      {
        const MeshSurface::Facet &facet = surface.facets()[last->facet];
        if (const auto st = projection_on(facet.map, x, last->st);
            st && is_on(facet, *st, true))
          if (const auto hit =
                hit_at(surface, last->facet, *st, x, n1, opposed);
              hit && std::abs(hit->distance) <= search_radius)
            return hit;
      }
    // Small boxes first: a near projection needs few facets.
    for (const double share : {1. / 64., 1. / 8., 1.})
      if (const auto hit =
            nearest_projection(surface, x, n1, share * search_radius, opposed))
        return hit;
    return {};
  }



  std::optional<SurfaceHit>
  closest_point_projection(const Obstacle     &obstacle,
                           const Point<3>     &x,
                           const Tensor<1, 3> &n1,
                           const double        search_radius)
  {
    SurfaceHit   hit;
    Tensor<1, 3> r = x - obstacle.point;
    if (obstacle.shape == Obstacle::Shape::plane)
      {
        hit.normal   = obstacle.direction;
        hit.distance = r * obstacle.direction;
      }
    else
      {
        r -= (r * obstacle.direction) * obstacle.direction;
        if (r.norm() == 0.)
          return {};
        hit.normal   = r / r.norm();
        hit.distance = r.norm() - obstacle.radius;
      }
    hit.position = x - hit.distance * hit.normal;
    if (std::abs(hit.distance) > search_radius ||
        n1 * hit.normal > -min_facing_cosine)
      return {};
    return hit;
  }
} // namespace lamella
