// SPDX-License-Identifier: LGPL-2.1-or-later

// Basis of a Lagrange expansion by products of integrated Legendre polynomials.

#include <lamella/section/lagrange_element.h>

#include <cmath>
#include <map>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    std::array<unsigned int, 5>
    key_of_vertex(const unsigned int vertex)
    {
      return {{1, 0, vertex, 0, 0}};
    }



    /// The product l_i l_j on @p cell, with its sign there: odd functions of an
    /// edge point from its vertex of the smaller number to the other.
    std::pair<std::array<unsigned int, 5>, double>
    key_of_product(const Triangulation<2>::active_cell_iterator &cell,
                   const unsigned int                            i,
                   const unsigned int                            j)
    {
      const unsigned int degree = std::max({i, j, 1u});
      if (i < 2 && j < 2)
        return {key_of_vertex(cell->vertex_index(i + 2 * j)), 1.};
      if (i > 1 && j > 1)
        return {{{degree, 2, cell->active_cell_index(), i, j}}, 1.};
      // deal.II's lines: x = 0, x = 1 upwards, z = 0, z = 1 to the right.
      const bool         upwards = i < 2;
      const unsigned int line    = upwards ? i : 2 + j;
      const unsigned int begin   = upwards ? i : 2 * j,
                         end     = upwards ? i + 2 : 2 * j + 1;
      const bool backwards =
        cell->vertex_index(end) < cell->vertex_index(begin);
      return {{{degree, 1, cell->line_index(line), degree, 0}},
              backwards && degree % 2 == 1 ? -1. : 1.};
    }



    /// l_0 ... l_p at @p t with their derivatives. The Legendre polynomials are
    /// 1 at s = 1 and +-1 at s = -1 to the last bit, so the l_k vanish there.
    void
    integrated_legendre(const unsigned int   p,
                        const double         t,
                        std::vector<double> &values,
                        std::vector<double> &derivatives)
    {
      const double        s = 2. * t - 1.;
      std::vector<double> P{1., s};
      for (unsigned int k = 2; k <= p; ++k)
        P.push_back(((2. * k - 1.) * s * P[k - 1] - (k - 1.) * P[k - 2]) / k);
      values      = {1. - t, t};
      derivatives = {-1., 1.};
      for (unsigned int k = 2; k <= p; ++k)
        {
          values.push_back((P[k] - P[k - 2]) / std::sqrt(4. * k - 2.));
          derivatives.push_back(std::sqrt(4. * k - 2.) * P[k - 1]);
        }
    }
  } // namespace



  std::map<LagrangeElement::ProductKey, unsigned int>
  LagrangeElement::number_products()
  {
    const unsigned int                 p = degree();
    std::map<ProductKey, unsigned int> numbers;
    std::vector<unsigned int>          vertices;
    std::vector<Point<2>>              positions;
    for (const auto &cell : mesh->mesh.active_cell_iterators())
      for (unsigned int i = 0; i <= p; ++i)
        for (unsigned int j = 0; j <= p; ++j)
          if (numbers.try_emplace(key_of_product(cell, i, j).first, 0).second &&
              i < 2 && j < 2)
            {
              vertices.push_back(cell->vertex_index(i + 2 * j));
              positions.push_back(cell->vertex(i + 2 * j));
            }
    for (const unsigned int node : replaced_nodes(positions))
      numbers.erase(key_of_vertex(vertices[node]));
    // Keys begin with their degree.
    levels.assign(3, 0);
    for (auto &[key, number] : numbers)
      {
        number = levels.size();
        levels.push_back(key[0]);
      }
    return numbers;
  }



  void
  LagrangeElement::number_hierarchical_functions()
  {
    const unsigned int p       = degree();
    const auto         numbers = number_products();
    for (const auto &cell : mesh->mesh.active_cell_iterators())
      {
        Cell &here = cells[cell->active_cell_index()];
        for (unsigned int i = 0; i <= p; ++i)
          for (unsigned int j = 0; j <= p; ++j)
            {
              const auto [key, sign] = key_of_product(cell, i, j);
              if (const auto found = numbers.find(key); found != numbers.end())
                here.products.push_back({found->second, {{i, j}}, sign});
            }
        std::sort(here.products.begin(),
                  here.products.end(),
                  [](const Product &a, const Product &b) {
                    return a.number < b.number;
                  });
        here.numbers = {0, 1, 2};
        for (const Product &product : here.products)
          here.numbers.push_back(product.number);
      }
  }



  void
  LagrangeElement::append_products(const Cell         &cell,
                                   const Point<2>     &unit,
                                   const Tensor<2, 2> &to_real,
                                   FunctionValues     &values) const
  {
    std::array<std::vector<double>, 2> l, d;
    for (unsigned int c = 0; c < 2; ++c)
      integrated_legendre(degree(), unit[c], l[c], d[c]);
    for (const auto &[number, indices, sign] : cell.products)
      {
        const auto [i, j] = indices;
        values.values.push_back(sign * l[0][i] * l[1][j]);
        values.gradients.push_back(
          to_real *
          Point<2>(sign * d[0][i] * l[1][j], sign * l[0][i] * d[1][j]));
      }
  }
} // namespace lamella
