// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/base/processes.h>
#include <lamella/body/facet_map.h>
#include <lamella/body/surface_topology.h>
#include <lamella/conditions/follower_pressure.h>

#include <deal.II/base/quadrature_lib.h>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// a x, so that (a x) b is the cross product of both.
    Tensor<2, 3>
    cross_matrix(const Tensor<1, 3> &a)
    {
      Tensor<2, 3> m;
      m[0][1] = -a[2];
      m[0][2] = a[1];
      m[1][0] = a[2];
      m[1][2] = -a[0];
      m[2][0] = -a[1];
      m[2][1] = a[0];
      return m;
    }



    /// A pressure p(X) per deformed area, opposite to the current outward
    /// normal. The work of p on a virtual displacement v of the surface x(s, t)
    /// is
    ///   f . v = -integral p v . (x_,s x x_,t) ds dt,
    /// with material coordinates s, t, integrated by Gauss points of each
    /// facet.
    class FollowerPressure : public FollowerLoad
    {
    public:
      /// Evaluates the pressure @p load at Gauss points of @p region on @p
      /// body.
      FollowerPressure(const Load &load, const Region &region, const Body &body)
      {
        check_surface(body, region.surface, "Load " + load.name + "/On");
        const Traction traction(load);
        for (const SurfaceFacet &facet : surface_facets(body, region.surface))
          facets.push_back(facet_of(body, facet, traction));
      }

      void
      add_forces(const double factor, const Vector &u, Vector &f) const override
      {
        for (const Facet &facet : facets)
          facet.nodes.add_forces(forces_on(facet, facet.moved(u), factor),
                                 1.,
                                 u,
                                 f);
      }

      void
      add_derivative(const double  factor,
                     const Vector &u,
                     const Vector &w,
                     Vector       &f) const override
      {
        for (const Facet &facet : facets)
          {
            const FacetMap            now = facet.moved(u);
            const FullMatrix<double>  K   = facet.stiffness(now, factor);
            const auto                by  = facet.nodes.changes(u, w);
            std::vector<Tensor<1, 3>> forces(by.size());
            for (unsigned int i = 0; i < K.m(); ++i)
              for (unsigned int j = 0; j < K.n(); ++j)
                forces[i / 3][i % 3] -= K(i, j) * by[j / 3][j % 3];
            if (is_root_process())
              facet.nodes.add_forces(forces, 1., u, f);
            facet.nodes.add_rotated_forces(
              forces_on(facet, now, factor), 1., u, w, f);
          }
      }

      void
      for_each_stiffness_block(const double         factor,
                               const Vector        &u,
                               const bool           with_values,
                               const BlockCallback &use) const override
      {
        for (const Facet &facet : facets)
          {
            const RowTransformation to_dofs(facet.nodes.rows(u));
            if (!with_values)
              {
                if (is_root_process())
                  use(to_dofs.pattern());
                continue;
              }
            const FacetMap     now = facet.moved(u);
            FullMatrix<double> K   = facet.stiffness(now, factor);
            K.symmetrize();
            if (is_root_process())
              use(to_dofs(K));
            facet.nodes.for_each_rotation_block(forces_on(facet, now, factor),
                                                -1.,
                                                u,
                                                use);
          }
      }

    private:
      /// A Gauss point at (s, t) with p times its weight, the values of the
      /// shape functions on the facet, and their derivatives by s and t.
      struct GaussPoint
      {
        dealii::Point<2>    st;
        double              pressure;
        std::vector<double> value, by_s, by_t;
      };
      /// A facet with its trace nodes, which interpolate the displacement on
      /// it.
      struct Facet
      {
        FacetMap                map;
        unsigned int            degree_s, degree_t;
        CurrentPoints           nodes;
        std::vector<GaussPoint> points;

        FacetMap
        moved(const Vector &u) const
        {
          return map.moved(degree_s, degree_t, nodes.displacements(u));
        }

        /// Returns -@p factor times the derivative of the nodal forces by nodal
        /// displacements, at the deformed facet @p at.
        dealii::FullMatrix<double>
        stiffness(const FacetMap &at, const double factor) const
        {
          const unsigned int n = (degree_s + 1) * (degree_t + 1);
          FullMatrix<double> K(3 * n, 3 * n);
          for (const GaussPoint &point : points)
            {
              const auto place = at(point.st);
              // d (x_s x x_t) = [x_s] du_t - [x_t] du_s, outwards.
              const double side =
                at.outward(place) * cross_product_3d(place.d_s, place.d_t) >
                    0. ?
                  1. :
                  -1.;
              const Tensor<2, 3> on_t = cross_matrix(place.d_s),
                                 on_s = cross_matrix(place.d_t);
              const double scale      = side * factor * point.pressure;
              for (unsigned int k = 0; k < n; ++k)
                for (unsigned int l = 0; l < n; ++l)
                  for (unsigned int c = 0; c < 3; ++c)
                    for (unsigned int d = 0; d < 3; ++d)
                      K(3 * k + c, 3 * l + d) += scale * point.value[k] *
                                                 (point.by_t[l] * on_t[c][d] -
                                                  point.by_s[l] * on_s[c][d]);
            }
          return K;
        }
      };
      /// Evaluates the shape functions on @p facet at @p point.
      static void
      evaluate(const SurfaceFacet &facet, GaussPoint &point)
      {
        const unsigned int n_s = facet.trace_degree_s + 1,
                           n_t = facet.trace_degree_t + 1;
        std::vector<double> s(n_s), ds(n_s), t(n_t), dt(n_t);
        GaussLobattoBasis::of_degree(facet.trace_degree_s)
          .evaluate(point.st[0], s.data(), ds.data());
        GaussLobattoBasis::of_degree(facet.trace_degree_t)
          .evaluate(point.st[1], t.data(), dt.data());
        for (unsigned int b = 0; b < n_t; ++b)
          for (unsigned int a = 0; a < n_s; ++a)
            {
              point.value.push_back(s[a] * t[b]);
              point.by_s.push_back(ds[a] * t[b]);
              point.by_t.push_back(s[a] * dt[b]);
            }
      }

      /// Returns the nodal forces on @p facet, times @p factor; @p now is the
      /// map of the deformed facet.
      static std::vector<dealii::Tensor<1, 3>>
      forces_on(const Facet &facet, const FacetMap &now, const double factor)
      {
        std::vector<Tensor<1, 3>> forces((facet.degree_s + 1) *
                                         (facet.degree_t + 1));
        for (const GaussPoint &point : facet.points)
          {
            const Tensor<1, 3> force =
              -factor * point.pressure * now.outward(now(point.st));
            for (unsigned int k = 0; k < forces.size(); ++k)
              forces[k] += point.value[k] * force;
          }
        return forces;
      }

      /// Returns the nodes that determine the displacement of @p facet.
      static std::vector<Location>
      nodes_of(const Body &body, const SurfaceFacet &facet)
      {
        const QGaussLobatto<1> s(facet.trace_degree_s + 1),
          t(facet.trace_degree_t + 1);
        std::vector<Location> nodes;
        for (unsigned int b = 0; b < t.size(); ++b)
          for (unsigned int a = 0; a < s.size(); ++a)
            nodes.push_back(
              body.surface_point(facet, {s.point(a)[0], t.point(b)[0]})
                .location);
        return nodes;
      }

      static Facet
      facet_of(const Body         &body,
               const SurfaceFacet &facet,
               const Traction     &traction)
      {
        Facet result{FacetMap(body, facet),
                     facet.trace_degree_s,
                     facet.trace_degree_t,
                     CurrentPoints(body, nodes_of(body, facet)),
                     {}};
        // Functions times normal have degree 3 n - 1; a varying pressure adds
        // two.
        const auto n_points = [](const unsigned int degree) {
          return (3 * degree + 3) / 2;
        };
        const QGauss<1> s(n_points(facet.trace_degree_s)),
          t(n_points(facet.trace_degree_t));
        for (unsigned int j = 0; j < t.size(); ++j)
          for (unsigned int i = 0; i < s.size(); ++i)
            {
              GaussPoint point;
              point.st           = Point<2>(s.point(i)[0], t.point(j)[0]);
              const auto   place = result.map(point.st);
              Tensor<1, 3> n     = result.map.outward(place);
              n /= n.norm();
              point.pressure = -(s.weight(i) * t.weight(j) *
                                 (traction(place.position, n) * n));
              evaluate(facet, point);
              result.points.push_back(point);
            }
        return result;
      }

      std::vector<Facet> facets;
    };
  } // namespace



  CurrentPoints::CurrentPoints(const Body           &body,
                               std::vector<Location> locations)
    : body(body)
    , locations(std::move(locations))
  {
    if (!body.constraints_rotate())
      fixed = body.rows(this->locations, undisplaced);
  }



  std::vector<std::vector<LinearFunctional>>
  CurrentPoints::rows(const Vector &u) const
  {
    return fixed.empty() ? body.rows(locations, u) : fixed;
  }



  std::vector<Tensor<1, 3>>
  CurrentPoints::displacements(const Vector &u) const
  {
    return fixed.empty() ? body.displacements(locations, u) : changes(u, u);
  }



  void
  CurrentPoints::add_forces(const std::vector<Tensor<1, 3>> &forces,
                            const double                     factor,
                            const Vector                    &u,
                            Vector                          &f) const
  {
    const auto at = rows(u);
    for (unsigned int k = 0; k < at.size(); ++k)
      for (unsigned int c = 0; c < 3; ++c)
        at[k][c].add_to(f, factor * forces[k][c]);
  }



  std::vector<Tensor<1, 3>>
  CurrentPoints::changes(const Vector &u, const Vector &w) const
  {
    const auto                at = rows(u);
    std::vector<Tensor<1, 3>> by(at.size());
    for (unsigned int k = 0; k < at.size(); ++k)
      for (unsigned int c = 0; c < 3; ++c)
        by[k][c] = at[k][c](w);
    return by;
  }



  void
  CurrentPoints::add_rotated_forces(const std::vector<Tensor<1, 3>> &forces,
                                    const double                     factor,
                                    const Vector                    &u,
                                    const Vector                    &w,
                                    Vector                          &f) const
  {
    for_each_rotation_block(forces,
                            factor,
                            u,
                            [&](const StiffnessBlock &block) {
                              block.add_product(w, f);
                            });
  }



  void
  CurrentPoints::for_each_rotation_block(
    const std::vector<Tensor<1, 3>> &forces,
    const double                     factor,
    const Vector                    &u,
    const BlockCallback             &use) const
  {
    body.for_each_block_of_forces(locations,
                                  forces,
                                  u,
                                  [&](const StiffnessBlock &block) {
                                    StiffnessBlock scaled = block;
                                    for (double &value : scaled.values)
                                      value *= factor;
                                    use(scaled);
                                  });
  }



  std::unique_ptr<FollowerLoad>
  make_follower_pressure(const Load   &load,
                         const Region &region,
                         const Body   &body)
  {
    return std::make_unique<FollowerPressure>(load, region, body);
  }
} // namespace lamella
