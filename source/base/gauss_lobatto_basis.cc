// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/gauss_lobatto_basis.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/quadrature_lib.h>

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
} // namespace lamella
