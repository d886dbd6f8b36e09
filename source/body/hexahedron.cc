// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/body/hexahedron.h>

#include <deal.II/lac/lapack_full_matrix.h>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// The strain (order of Eq. 4) of the displacement f e_component where f
    /// has the gradient @p g.
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
  } // namespace



  Hexahedron::Hexahedron(const unsigned int degree)
    : fe(degree)
    , gauss(degree + 1)
  {}



  HexahedronPoint
  Hexahedron::evaluate(const Nodes &nodes, const Point<3> &unit) const
  {
    HexahedronPoint point;
    point.unit = unit;
    point.N.resize(nodes.size());
    point.gradients.resize(nodes.size());
    for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        point.N[i]         = fe.shape_value(i, unit);
        point.gradients[i] = fe.shape_grad(i, unit);
        // Of the differences to the first node: no digits lost far from the
        // origin.
        const Tensor<1, 3> x = nodes[i] - nodes[0];
        point.position += point.N[i] * x;
        point.jacobian += outer_product(x, point.gradients[i]);
      }
    point.position += Tensor<1, 3>(nodes[0]);
    const Tensor<2, 3> to_physical = transpose(invert(point.jacobian));
    for (Tensor<1, 3> &gradient : point.gradients)
      gradient = to_physical * gradient;
    return point;
  }



  std::vector<Voigt>
  Hexahedron::mode_strains(const Nodes           &nodes,
                           const HexahedronPoint &point) const
  {
    const Tensor<2, 3> middle =
      evaluate(nodes, Point<3>(0.5, 0.5, 0.5)).jacobian;
    const Tensor<2, 3> to_physical =
      (determinant(middle) / determinant(point.jacobian)) *
      transpose(invert(middle));
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



  FullMatrix<double>
  Hexahedron::incompatible_modes(const Nodes         &nodes,
                                 const ElasticTensor &C) const
  {
    if (degree() > 1)
      return FullMatrix<double>();
    const unsigned int       n = 3 * n_nodes();
    LAPACKFullMatrix<double> K_aa(9), K_au(9, n);
    const FullMatrix<double> none;
    for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        const HexahedronPoint    point = evaluate(nodes, gauss.point(q));
        const std::vector<Voigt> of_u  = strains(nodes, point, none),
                                 of_a  = mode_strains(nodes, point);
        const double weight = gauss.weight(q) * determinant(point.jacobian);
        for (unsigned int k = 0; k < 9; ++k)
          {
            const Voigt stress = weight * (C * of_a[k]);
            for (unsigned int m = 0; m < 9; ++m)
              K_aa(k, m) += stress * of_a[m];
            for (unsigned int d = 0; d < n; ++d)
              K_au(k, d) += stress * of_u[d];
          }
      }
    K_aa.compute_lu_factorization();
    K_aa.solve(K_au);
    FullMatrix<double> A(9, n);
    for (unsigned int k = 0; k < 9; ++k)
      for (unsigned int d = 0; d < n; ++d)
        A(k, d) = -K_au(k, d);
    return A;
  }



  std::vector<Voigt>
  Hexahedron::strains(const Nodes              &nodes,
                      const HexahedronPoint    &point,
                      const FullMatrix<double> &A) const
  {
    std::vector<Voigt> result;
    for (const Tensor<1, 3> &gradient : point.gradients)
      for (unsigned int c = 0; c < 3; ++c)
        result.push_back(strain_of(gradient, c));
    if (A.m() > 0)
      {
        const std::vector<Voigt> of_modes = mode_strains(nodes, point);
        for (unsigned int d = 0; d < result.size(); ++d)
          for (unsigned int k = 0; k < 9; ++k)
            result[d] += A(k, d) * of_modes[k];
      }
    return result;
  }



  FullMatrix<double>
  Hexahedron::stiffness(const Nodes              &nodes,
                        const ElasticTensor      &C,
                        const FullMatrix<double> &A) const
  {
    const unsigned int       n = 3 * n_nodes();
    LAPACKFullMatrix<double> strain(6 * gauss.size(), n),
      stress(6 * gauss.size(), n), product(n);
    for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        const HexahedronPoint    point = evaluate(nodes, gauss.point(q));
        const std::vector<Voigt> B     = strains(nodes, point, A);
        const double weight = gauss.weight(q) * determinant(point.jacobian);
        for (unsigned int d = 0; d < n; ++d)
          {
            const Voigt CB = weight * (C * B[d]);
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
