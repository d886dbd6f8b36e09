// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/body/surface_topology.h>
#include <lamella/conditions/couple.h>

#include <deal.II/base/quadrature_lib.h>

namespace lamella
{
  using namespace dealii;

  Couple::Couple(const Load &load, const Region &region, const Body &body)
    : moment(*load.couple)
  {
    check_surface(body, region.surface, "Load " + load.name + "/On");
    for (const SurfaceFacet &facet : surface_facets(body, region.surface))
      {
        const QGauss<1> s(facet.trace_degree_s + 2),
          t(facet.trace_degree_t + 2);
        for (unsigned int j = 0; j < t.size(); ++j)
          for (unsigned int i = 0; i < s.size(); ++i)
            {
              all.push_back(
                body.surface_point(facet,
                                   Point<2>(s.point(i)[0], t.point(j)[0])));
              all.back().area *= s.weight(i) * t.weight(j);
            }
      }
  }



  Couple::Place
  Couple::place(const std::vector<Point<3>> &x) const
  {
    double       area = 0.;
    Tensor<1, 3> center;
    for (unsigned int k = 0; k < all.size(); ++k)
      {
        area += all[k].area;
        center += all[k].area * x[k];
      }
    center /= area;
    Tensor<2, 3> J;
    for (unsigned int k = 0; k < all.size(); ++k)
      {
        const Tensor<1, 3> r = x[k] - center;
        for (unsigned int c = 0; c < 3; ++c)
          J[c][c] += all[k].area * r.norm_square();
        J -= all[k].area * outer_product(r, r);
      }
    const Tensor<2, 3> inverse = invert(J);
    return {center, inverse, inverse * moment};
  }



  std::vector<Tensor<1, 3>>
  Couple::forces(const std::vector<Point<3>> &x) const
  {
    const Place               at = place(x);
    std::vector<Tensor<1, 3>> result;
    for (unsigned int k = 0; k < all.size(); ++k)
      result.push_back(all[k].area *
                       cross_product_3d(at.theta, x[k] - at.center));
    return result;
  }



  std::vector<Tensor<1, 3>>
  Couple::change(const std::vector<Point<3>>     &x,
                 const std::vector<Tensor<1, 3>> &u) const
  {
    const Place          at   = place(x);
    const CoupleRotation by   = rotation_of(x);
    double               area = 0.;
    Tensor<1, 3>         center, of_theta;
    for (unsigned int p = 0; p < all.size(); ++p)
      {
        area += all[p].area;
        center += all[p].area * u[p];
        for (unsigned int k = 0; k < 3; ++k)
          of_theta[k] -= by.stretch[k][p] * u[p];
      }
    center /= area;
    of_theta = at.inverse * of_theta;
    std::vector<Tensor<1, 3>> result;
    for (unsigned int p = 0; p < all.size(); ++p)
      result.push_back(all[p].area *
                       (cross_product_3d(at.theta, u[p] - center) +
                        cross_product_3d(of_theta, x[p] - at.center)));
    return result;
  }



  Couple::CoupleRotation
  Couple::rotation_of(const std::vector<Point<3>> &x) const
  {
    const Place         at    = place(x);
    const Tensor<1, 3> &theta = at.theta;
    CoupleRotation      result;
    for (unsigned int p = 0; p < all.size(); ++p)
      {
        const Tensor<1, 3> r = x[p] - at.center;
        for (unsigned int k = 0; k < 3; ++k)
          {
            Tensor<1, 3> along;
            along[k] = 1.;
            // The row k of J^-1 [r]x is that vector times [r]x.
            result.spin[k].push_back(all[p].area *
                                     cross_product_3d(at.inverse[k], r));
            result.stretch[k].push_back(
              all[p].area *
              (2. * theta[k] * r - (r * theta) * along - r[k] * theta));
          }
      }
    return result;
  }



  PointForces
  Couple::dead_load() const
  {
    PointForces           result;
    std::vector<Point<3>> x;
    for (const SurfacePoint &point : all)
      {
        result.locations.push_back(point.location);
        x.push_back(point.position);
      }
    result.forces = forces(x);
    return result;
  }
} // namespace lamella
