// SPDX-License-Identifier: LGPL-2.1-or-later

// Mortar integrals of moving contacts, by sums over points X_q with constant
// weights a_q phi_i(X_q):
//   g_i = sum a_q phi_i g_q / A_i,   A_i = sum a_q phi_i,
//   w_ik = sum a_q phi_i psi_k n / A_i,
//   P_ik = sum a_q phi_i psi_k (I - n n) / A_i,
// the gap, its gradient and the tangential projector of the slip. As the
// projections are stationary and the weights constant, the gradient of g_i is
// the average of the gradients (Puso and Laursen, CMAME 193 (2004) 601-629).
//
// Both sides have the same sums of weights: sum_j w_ij = sum_k w_ik = mean n,
// so contact forces balance (action and reaction).

#include <lamella/contact/gap_integrals.h>
#include <lamella/contact/mesh_surface.h>

#include <cmath>

namespace lamella
{
  using namespace dealii;

  // Slip of a step from the change of the projections, objective by
  // construction: both points of a pair move with their bodies, and only the
  // distance of the projections on each surface counts (Wriggers, Computational
  // Contact Mechanics, Springer 2006, Sec. 4.2). Tangents are convected. The
  // same distance of points that face the other surface at one end of a step
  // only is that of the two material points that face each other at the other
  // end.

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



    /// Returns the slip reference point of the contact point @p point, which
    /// faces the master point @p at on the surfaces @p sides.
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



    /// Returns the slip of a contact point in a load step: the tangential
    /// motion [length] of the master surface relative to the slave surface,
    /// from the reference @p then to the point @p now, which faces @p at on @p
    /// sides,
    ///   s = P (x_c(C) - x_c(C_0)) - P (x_o(O) - x_o(O_0)),   P = I - n n,
    /// where C and O are the material points of the slave and master surface
    /// now in contact, C_0 and O_0 those of the reference, and x_c and x_o
    /// current positions. C is C_0 except on the line of a roller contact. The
    /// slave is the second surface if @p on_second is true, else the first. s
    /// is invariant to rigid motions of both bodies and to rotations of n.
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



    /// Returns the slip in a load step of a contact point that faced the master
    /// surface at the reference @p then, but has left it past an edge,
    ///   s = P (x_o(O_0) - x_c(C_0)),
    /// with the slave normal n now.
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



    /// Returns the slip in a load step of a contact point @p now that has come
    /// over the master surface from past an edge. With the surfaces @p began at
    /// the beginning of the step and the tangents t_a of the slave surface,
    ///   s = sum over a of (x_c(C) - x_o(O)) . t_a at the beginning, times t_a
    ///   at
    /// @p at, on the surfaces @p sides now.
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
          at.hit.position +
            (began.obstacle()->point - sides.obstacle()->point) :
          position(*began.surface(!on_second), now.master);
      const Tensor<1, 3> way  = before(st).position - master;
      const Tangents     then = tangents_of(before.outward(before(st))),
                     t = convected_tangents(before, moved, st, at.normal);
      return (way * then[0]) * t[0] + (way * then[1]) * t[1];
    }



    /// Sums over the points of a contact, row by row.
    class Sums
    {
    public:
      Sums(const ContactSides &sides,
           const bool          on_second,
           const SlaveSurface *functions,
           const unsigned int  n_rows)
        : slave(*sides.surface(on_second))
        , master(sides.surface(!on_second))
        , functions(functions)
        , rows(n_rows)
        , left(n_rows)
      {}

      // Adds one point to its rows: area, gap, normal, slip, and the products
      // of trace functions psi_k of both sides with n and I - n n.
      void
      add(const unsigned int  number,
          const GapPoint     &point,
          const MasterPoint  &at,
          const Tensor<1, 3> &slip_increment)
      {
        const Tensor<1, 3>       &n     = at.normal;
        const MeshSurface::Facet &facet = slave.facets()[point.slave.facet];
        slave.evaluate_trace(facet, point.slave.st, trace);
        const std::vector<unsigned int> *beyond = nullptr;
        if (master != nullptr)
          {
            const auto &other = master->facets()[point.master.facet];
            master->evaluate_trace(other, point.master.st, trace_opposite);
            beyond = &other.trace_nodes;
          }
        // Tangential projector I - n n; times t it weights the slip along t.
        const SymmetricTensor<2, 3> tangential =
          unit_symmetric_tensor<3>() - symmetrize(outer_product(n, n));
        const auto add_side = [&](const std::vector<unsigned int> &nodes,
                                  const std::vector<double>       &values,
                                  const double                     weight,
                                  auto                            &sums) {
          for (unsigned int k = 0; k < nodes.size(); ++k)
            if (values[k] != 0.)
              {
                GapIntegrals::OfNode &node = sums[nodes[k]];
                node.normal += (weight * values[k]) * n;
                node.tangential += (weight * values[k]) * tangential;
              }
        };
        for (const auto &[row, weight] : shares_of(functions, number, point))
          {
            GapIntegrals &sum = rows[row];
            sum.area += weight;
            sum.gap += weight * at.hit.distance;
            sum.normal += weight * n;
            sum.slip_increment += weight * slip_increment;
            add_side(facet.trace_nodes, trace, weight, sum.slave);
            if (beyond != nullptr)
              add_side(*beyond, trace_opposite, weight, sum.master);
          }
      }

      /// Adds a point without projection, which has slipped past an edge.
      void
      add_left(const unsigned int  number,
               const GapPoint     &point,
               const Tensor<1, 3> &slip_increment)
      {
        for (const auto &[row, weight] : shares_of(functions, number, point))
          {
            left[row].first += weight;
            left[row].second += weight * slip_increment;
          }
      }

      // Divides the sums by the areas A_i. A row whose points have all left has
      // no gap; its slip is the mean of theirs, up to the edge.
      std::vector<GapIntegrals>
      take()
      {
        for (unsigned int k = 0; k < rows.size(); ++k)
          if (rows[k].area == 0. && left[k].first > 0.)
            rows[k].slip_increment = left[k].second / left[k].first;
        for (GapIntegrals &row : rows)
          if (row.area > 0.)
            {
              const double scale = 1. / row.area;
              row.gap *= scale;
              row.normal *= scale;
              row.slip_increment *= scale;
              for (auto *side : {&row.slave, &row.master})
                for (auto &[number, node] : *side)
                  {
                    node.normal *= scale;
                    node.tangential *= scale;
                  }
            }
        return std::move(rows);
      }

    private:
      const MeshSurface        &slave, *master;
      const SlaveSurface       *functions;
      std::vector<GapIntegrals> rows;
      /// Sums of weights, and of weights times slips, of points that have left.
      std::vector<std::pair<double, Tensor<1, 3>>> left;
      std::vector<double>                          trace, trace_opposite;
    };



    /// Returns the stored master point with the averaged normal n = (n_1 - n_2)
    /// / |n_1 - n_2| at the current positions (node pairs).
    std::optional<MasterPoint>
    kept(const ContactSides &sides,
         const MeshSurface  *master,
         const GapPoint     &point,
         const Point<3>     &x,
         const Tensor<1, 3> &n1,
         const double        search_radius)
    {
      if (master == nullptr)
        return find_master_point(ObstacleSurface(sides.obstacle()),
                                 x,
                                 n1,
                                 search_radius);
      const MeshSurface::Facet &facet = master->facets()[point.master.facet];
      MasterPoint               at;
      at.hit.position = facet.map(point.master.st).position;
      at.hit.normal   = master->smooth_normal(facet, point.master.st);
      at.normal       = n1 - at.hit.normal;
      at.normal /= at.normal.norm();
      at.hit.distance = at.normal * (at.hit.position - x);
      at.hit.facet    = point.master.facet;
      at.hit.st       = point.master.st;
      return at;
    }



    /// Returns the closest-point projection of @p x, which becomes the new
    /// starting point of @p point; the normal is -n_2.
    /// Edge contact admits normals up to 90 degrees, surfaces up to 60 degrees.
    std::optional<MasterPoint>
    found(const ContactSides &sides,
          const MeshSurface  *master,
          GapPoint           &point,
          const Point<3>     &x,
          const Tensor<1, 3> &n1,
          const double        search_radius)
    {
      // The previous projection is the starting point of Newton's method.
      const auto hit =
        master == nullptr ?
          closest_point_projection(*sides.obstacle(), x, n1, search_radius) :
          closest_point_projection(*master,
                                   x,
                                   n1,
                                   search_radius,
                                   point.master,
                                   sides.is_edge_contact() ?
                                     min_facing_cosine_edge :
                                     min_facing_cosine);
      if (!hit)
        return {};
      point.master = {hit->facet, hit->st};
      MasterPoint at;
      at.hit    = *hit;
      at.normal = -hit->normal;
      return at;
    }



    /// Returns the master point of @p point, which is projected or kept.
    std::optional<MasterPoint>
    master_point(const ContactSides &sides,
                 const bool          on_second,
                 const MasterPoints  master_points,
                 const double        search_radius,
                 GapPoint           &point)
    {
      const MeshSurface &slave       = *sides.surface(on_second),
                        *master      = sides.surface(!on_second);
      const auto &[facet, st]        = point.slave;
      const MeshSurface::Facet &from = slave.facets()[facet];
      const Point<3>            x    = from.map(st).position;
      const Tensor<1, 3>        n1   = slave.smooth_normal(from, st);
      return master_points == MasterPoints::paired ?
               kept(sides, master, point, x, n1, search_radius) :
               found(sides, master, point, x, n1, search_radius);
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



  // Weights a_q phi_i(X_q) for the rows i of the facet's nodes; a single-point
  // row has its area as weight.
  std::vector<std::pair<unsigned int, double>>
  shares_of(const SlaveSurface *functions,
            const unsigned int  number,
            const GapPoint     &point)
  {
    if (functions == nullptr)
      return {{number, point.area}};
    std::vector<std::pair<unsigned int, double>> result;
    const auto  phi = functions->functions_at({point.part, point.slave.st});
    const auto &of_nodes = functions->facets()[point.part].rows;
    for (unsigned int i = 0; i < phi.size(); ++i)
      for (const auto &[row, share] : of_nodes[i])
        if (phi[i] != 0.)
          result.emplace_back(row, phi[i] * share * point.area);
    return result;
  }



  // The slip of a point in the load step depends on whether it faces the master
  // surface now, and whether it did at the beginning of the step:
  // both: from there to here; only now: from the edge; only then: to the edge.
  std::vector<GapIntegrals>
  integrate_gaps(const ContactSides        &sides,
                 const bool                 on_second,
                 const SlaveSurface        *functions,
                 const unsigned int         n_rows,
                 const MasterPoints         master_points,
                 const double               search_radius,
                 std::vector<GapPoint>     &points,
                 const SlipReference *const reference)
  {
    Sums sums(sides, on_second, functions, n_rows);
    for (unsigned int q = 0; q < points.size(); ++q)
      {
        if (points[q].area == 0.)
          continue;
        const auto at = master_point(
          sides, on_second, master_points, search_radius, points[q]);
        const auto *then = reference != nullptr && reference->points[q] ?
                             &*reference->points[q] :
                             nullptr;
        if (at && then != nullptr)
          sums.add(q,
                   points[q],
                   *at,
                   slip_increment_of(sides, on_second, *then, points[q], *at));
        else if (at)
          sums.add(q,
                   points[q],
                   *at,
                   reference == nullptr ?
                     Tensor<1, 3>() :
                     slip_from_past_edge(
                       *reference->sides, sides, on_second, points[q], *at));
        else if (then != nullptr)
          sums.add_left(q, points[q], slip_past_edge(sides, on_second, *then));
      }
    return sums.take();
  }



  // Pairs at the beginning of a step, from which slip_increment_of() measures.
  SlipReferencePoints
  slip_reference_points(const ContactSides    &sides,
                        const bool             on_second,
                        const MasterPoints     master_points,
                        const double           search_radius,
                        std::vector<GapPoint> &points)
  {
    SlipReferencePoints held(points.size());
    for (unsigned int q = 0; q < points.size(); ++q)
      if (const auto at = master_point(
            sides, on_second, master_points, search_radius, points[q]))
        held[q] = slip_reference_point(sides, points[q], *at);
    return held;
  }
} // namespace lamella
