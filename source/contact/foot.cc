// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/contact/foot.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Of a facet's length: how far a foot goes beyond a side with a neighbour.
    constexpr double beyond = 0.05;



    /// a_ab - r . X_,ab at @p st; r = x - X.
    Tensor<2, 2>
    foot_matrix(const FacetMap        &map,
                const Point<2>        &st,
                const FacetMap::Place &place,
                const Tensor<1, 3>    &r)
    {
      Tensor<2, 2> matrix;
      matrix[0][0] = place.d_s * place.d_s;
      matrix[0][1] = matrix[1][0] = place.d_s * place.d_t;
      matrix[1][1]                = place.d_t * place.d_t;
      if (map.is_affine())
        return matrix;
      constexpr double step = arithmetic::same_in_element;
      for (unsigned int a = 0; a < 2; ++a)
        {
          Point<2> ahead = st, behind = st;
          ahead[a] += step;
          behind[a] -= step;
          const auto next = map(ahead), last = map(behind);
          matrix[0][a] -= r * (next.d_s - last.d_s) / (2. * step);
          matrix[1][a] -= r * (next.d_t - last.d_t) / (2. * step);
        }
      return matrix;
    }



    /// Whether @p st is on the facet, or on its continuation by no more than
    /// @p slack where a neighbour goes on.
    bool
    is_on(const MeshSurface::Facet &facet,
          const Point<2>           &st,
          const double              slack)
    {
      const auto room = [&](const unsigned int side) {
        return facet.goes_on[side] ?
                 std::max(slack, arithmetic::same_in_element) :
                 arithmetic::same_in_element;
      };
      return st[0] >= -room(0) && st[0] <= 1. + room(1) && st[1] >= -room(2) &&
             st[1] <= 1. + room(3);
    }



    std::optional<SurfaceHit>
    foot_on_facet(const MeshSurface  &surface,
                  const unsigned int  number,
                  const Point<3>     &x,
                  const Tensor<1, 3> &n1,
                  const Point<2>     &start,
                  const double        slack)
    {
      const MeshSurface::Facet &facet = surface.facets()[number];
      const auto                st    = foot_on(facet.map, x, start);
      if (!st || !is_on(facet, *st, slack))
        return {};
      const auto place = facet.map(*st);
      SurfaceHit hit;
      hit.position = place.position;
      hit.normal   = surface.outward_normal(facet, place);
      hit.distance = hit.normal * (x - hit.position);
      hit.facet    = number;
      hit.st       = *st;
      if (n1 * hit.normal > -faces_from_60)
        return {};
      return hit;
    }
  } // namespace



  std::optional<Point<2>>
  foot_on(const FacetMap &map, const Point<3> &x, const Point<2> &start)
  {
    constexpr unsigned int max_iterations = 30;
    Point<2>               st             = start;
    for (unsigned int k = 0; k < max_iterations; ++k)
      {
        const auto         place = map(st);
        const Tensor<1, 3> r     = x - place.position;
        const Tensor<1, 2> step  = invert(foot_matrix(map, st, place, r)) *
                                  Tensor<1, 2>({place.d_s * r, place.d_t * r});
        st += step;
        // Written so that what is not a number ends it.
        if (!(st.norm() < 10.))
          return {};
        if (map.is_affine() || step.norm() < arithmetic::rounding_of_sums)
          return st;
      }
    return {};
  }



  std::optional<SurfaceHit>
  find_foot(const MeshSurface             &surface,
            const Point<3>                &x,
            const Tensor<1, 3>            &n1,
            const double                   reach,
            const MeshSurface::FacetPlace &last)
  {
    if (const auto hit =
          foot_on_facet(surface, last.facet, x, n1, last.st, beyond);
        hit && std::abs(hit->distance) <= reach)
      return hit;
    const Tensor<1, 3> around({reach, reach, reach});
    const auto         near = surface.facets_near({x - around, x + around});
    std::optional<SurfaceHit> nearest;
    // Between two facets that bulge a foot is on the continuation of either.
    for (const double slack : {0., beyond})
      {
        for (const unsigned int facet : near)
          if (const auto hit =
                foot_on_facet(surface, facet, x, n1, {0.5, 0.5}, slack);
              hit && std::abs(hit->distance) <=
                       (nearest ? std::abs(nearest->distance) : reach))
            nearest = hit;
        if (nearest)
          break;
      }
    return nearest;
  }



  std::optional<SurfaceHit>
  find_foot(const Obstacle     &obstacle,
            const Point<3>     &x,
            const Tensor<1, 3> &n1,
            const double        reach)
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
    if (std::abs(hit.distance) > reach || n1 * hit.normal > -faces_from_60)
      return {};
    return hit;
  }
} // namespace lamella
