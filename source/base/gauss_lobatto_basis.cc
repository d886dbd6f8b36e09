// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/gauss_lobatto_basis.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <map>
#include <memory>

namespace lamella
{
  using namespace dealii;

  GaussLobattoBasis::GaussLobattoBasis(const unsigned int degree)
  {
    const QGaussLobatto<1> nodes(degree + 1);
    AssertThrow(nodes.size() <= max_size, ExcNotImplemented());
    for (const Point<1> &node : nodes.get_points())
      points.push_back(node[0]);
    for (unsigned int i = 0; i < size(); ++i)
      {
        double product = 1.;
        for (unsigned int j = 0; j < size(); ++j)
          if (j != i)
            product *= points[i] - points[j];
        scales.push_back(1. / product);
      }
  }



  void
  GaussLobattoBasis::evaluate(const double x,
                              double      *values,
                              double      *derivatives,
                              double      *second_derivatives) const
  {
    for (unsigned int i = 0; i < size(); ++i)
      {
        double value = scales[i], derivative = 0., second = 0.;
        for (unsigned int j = 0; j < size(); ++j)
          if (j != i)
            {
              second     = second * (x - points[j]) + 2. * derivative;
              derivative = derivative * (x - points[j]) + value;
              value *= x - points[j];
            }
        values[i] = value;
        if (derivatives != nullptr)
          derivatives[i] = derivative;
        if (second_derivatives != nullptr)
          second_derivatives[i] = second;
      }
  }



  const GaussLobattoBasis &
  GaussLobattoBasis::of_degree(const unsigned int degree)
  {
    static std::map<unsigned int, std::unique_ptr<GaussLobattoBasis>> known;
    auto &basis = known[degree];
    if (basis == nullptr)
      basis = std::make_unique<GaussLobattoBasis>(degree);
    return *basis;
  }



  std::vector<Point<2>>
  grid_points(const GaussLobattoBasis &s, const GaussLobattoBasis &t)
  {
    std::vector<Point<2>> points;
    for (unsigned int j = 0; j < t.size(); ++j)
      for (unsigned int i = 0; i < s.size(); ++i)
        points.emplace_back(s.point(i), t.point(j));
    return points;
  }



  void
  evaluate_on_grid(const GaussLobattoBasis &s,
                   const GaussLobattoBasis &t,
                   const Point<2>          &st,
                   std::vector<double>     &values)
  {
    std::array<double, GaussLobattoBasis::max_size> of_s, of_t;
    s.evaluate(st[0], of_s.data(), nullptr);
    t.evaluate(st[1], of_t.data(), nullptr);
    values.clear();
    for (unsigned int j = 0; j < t.size(); ++j)
      for (unsigned int i = 0; i < s.size(); ++i)
        values.push_back(of_s[i] * of_t[j]);
  }
} // namespace lamella
