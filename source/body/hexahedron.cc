// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/body/hexahedron.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

#include <deal.II/grid/grid_generator.h>

#include <deal.II/lac/lapack_full_matrix.h>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// The strain (Eq. 4) of f e_component, where f has the gradient @p g.
    Voigt
    strain_of(const Tensor<1, 3> &g, const unsigned int component)
    {
      Voigt strain;
      strain[component] = g[component];
      // xy, xz and yz.
      constexpr std::array<std::array<unsigned int, 2>, 3> planes{
        {{{0, 1}}, {{0, 2}}, {{1, 2}}}};
      for (unsigned int s = 0; s < 3; ++s)
        {
          const auto &[a, b] = planes[s];
          if (component == a)
            strain[3 + s] = g[b];
          else if (component == b)
            strain[3 + s] = g[a];
        }
      return strain;
    }



    /// The strains of the nine modes at @p point; @p middle is det J_0 J_0^-T.
    std::vector<Voigt>
    mode_strains(const HexahedronPoint &point, const Tensor<2, 3> &middle)
    {
      const Tensor<2, 3> to_physical = middle / determinant(point.jacobian);
      std::vector<Voigt> strains;
      for (unsigned int k = 0; k < 3; ++k)
        {
          // d (1 - (2 t - 1)^2) / dt.
          Tensor<1, 3> gradient;
          gradient[k] = 4. * (1. - 2. * point.unit[k]);
          for (unsigned int c = 0; c < 3; ++c)
            strains.push_back(strain_of(to_physical * gradient, c));
        }
      return strains;
    }
  } // namespace



  Hexahedron::Hexahedron(const unsigned int degree)
    : fe(degree)
    , geometry(degree)
    , at_point(geometry, fe, update_jacobians | update_inverse_jacobians)
  {
    GridGenerator::hyper_cube(any_cell);
  }



  Triangulation<3>::active_cell_iterator
  Hexahedron::cell(const Nodes &nodes) const
  {
    geometry.initialize(any_cell, [&nodes](const auto &) {
      Nodes relative;
      for (const Point<3> &x : nodes)
        relative.emplace_back(x - nodes[0]);
      return relative;
    });
    return any_cell.begin_active();
  }



  HexahedronPoint
  Hexahedron::evaluate(const Nodes &nodes, const Point<3> &unit) const
  {
    // FEValues, made anew for each point, takes 10 to 16 us instead of 1.
    std::vector<Tensor<2, 3>> second;
    std::vector<Tensor<3, 3>> third;
    std::vector<Tensor<4, 3>> fourth;
    HexahedronPoint           point;
    point.unit = unit;
    point.N.resize(n_nodes());
    point.gradients.resize(n_nodes());
    fe.get_poly_space().evaluate(
      unit, point.N, point.gradients, second, third, fourth);

    at_point.reinit(cell(nodes), ArrayView<const Point<3>>(&unit, 1));
    point.position = at_point.real_point(0) + nodes[0];
    point.jacobian = at_point.jacobian(0);
    for (Tensor<1, 3> &gradient : point.gradients)
      gradient = apply_transformation(at_point.inverse_jacobian(0).transpose(),
                                      gradient);
    return point;
  }



  std::vector<HexahedronPoint>
  Hexahedron::quadrature_points(const Nodes &nodes) const
  {
    // Made anew each time: FEValues that are kept take a cell of degree 1 that
    // is where it was for the same one.
    FEValues<3> values(geometry,
                       fe,
                       QGauss<3>(degree() + 1),
                       update_values | update_gradients | update_jacobians |
                         update_quadrature_points | update_JxW_values);
    values.reinit(cell(nodes));
    std::vector<HexahedronPoint> points(values.n_quadrature_points);
    for (const unsigned int q : values.quadrature_point_indices())
      {
        points[q].unit     = values.get_quadrature().point(q);
        points[q].position = values.quadrature_point(q) + nodes[0];
        points[q].jacobian = values.jacobian(q);
        points[q].JxW      = values.JxW(q);
        for (const unsigned int i : values.dof_indices())
          {
            points[q].N.push_back(values.shape_value(i, q));
            points[q].gradients.push_back(values.shape_grad(i, q));
          }
      }
    return points;
  }



  IncompatibleModes
  Hexahedron::incompatible_modes(const Nodes          &nodes,
                                 const StiffnessField &C) const
  {
    if (degree() > 1)
      return IncompatibleModes();
    const Tensor<2, 3> J = evaluate(nodes, Point<3>(0.5, 0.5, 0.5)).jacobian;
    IncompatibleModes  modes;
    modes.middle = determinant(J) * transpose(invert(J));

    const unsigned int       n = 3 * n_nodes();
    LAPACKFullMatrix<double> K_aa(9), K_au(9, n);
    for (const HexahedronPoint &point : quadrature_points(nodes))
      {
        const std::vector<Voigt> of_u = strains(point, IncompatibleModes()),
                                 of_a = mode_strains(point, modes.middle);
        const ElasticTensor C_here    = C(point.position);
        for (unsigned int k = 0; k < 9; ++k)
          {
            const Voigt stress = point.JxW * (C_here * of_a[k]);
            for (unsigned int m = 0; m < 9; ++m)
              K_aa(k, m) += stress * of_a[m];
            for (unsigned int d = 0; d < n; ++d)
              K_au(k, d) += stress * of_u[d];
          }
      }
    K_aa.compute_lu_factorization();
    K_aa.solve(K_au);
    modes.A.reinit(9, n);
    for (unsigned int k = 0; k < 9; ++k)
      for (unsigned int d = 0; d < n; ++d)
        modes.A(k, d) = -K_au(k, d);
    return modes;
  }



  std::vector<Voigt>
  Hexahedron::strains(const HexahedronPoint   &point,
                      const IncompatibleModes &modes) const
  {
    std::vector<Voigt> result;
    for (const Tensor<1, 3> &gradient : point.gradients)
      for (unsigned int c = 0; c < 3; ++c)
        result.push_back(strain_of(gradient, c));
    if (!modes.A.empty())
      {
        const std::vector<Voigt> of_modes = mode_strains(point, modes.middle);
        for (unsigned int d = 0; d < result.size(); ++d)
          for (unsigned int k = 0; k < 9; ++k)
            result[d] += modes.A(k, d) * of_modes[k];
      }
    return result;
  }



  FullMatrix<double>
  Hexahedron::stiffness(const Nodes             &nodes,
                        const StiffnessField    &C,
                        const IncompatibleModes &modes) const
  {
    const unsigned int                 n      = 3 * n_nodes();
    const std::vector<HexahedronPoint> points = quadrature_points(nodes);
    LAPACKFullMatrix<double>           strain(6 * points.size(), n),
      stress(6 * points.size(), n), product(n);
    for (unsigned int q = 0; q < points.size(); ++q)
      {
        const std::vector<Voigt> B      = strains(points[q], modes);
        const ElasticTensor      C_here = C(points[q].position);
        for (unsigned int d = 0; d < n; ++d)
          {
            const Voigt CB = points[q].JxW * (C_here * B[d]);
            for (unsigned int s = 0; s < 6; ++s)
              {
                strain(6 * q + s, d) = B[d][s];
                stress(6 * q + s, d) = CB[s];
              }
          }
      }
    strain.Tmmult(product, stress);
    FullMatrix<double> result(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        result(i, j) = 0.5 * (product(i, j) + product(j, i));
    return result;
  }
} // namespace lamella
