// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/conditions/moment_rule.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Values this share of their range beyond it are new: between Gauss points
    // and the edges of their cell a polynomial goes on.
    constexpr double new_value = 0.25;
  } // namespace



  template <int dim>
  double
  ParameterBox<dim>::volume() const
  {
    double v = 1.;
    for (unsigned int d = 0; d < dim; ++d)
      v *= high[d] - low[d];
    return v;
  }



  template <int dim>
  Point<dim>
  ParameterBox<dim>::center() const
  {
    return low + 0.5 * (high - low);
  }



  template <int dim>
  std::array<ParameterBox<dim>, 2>
  ParameterBox<dim>::halves(const unsigned int d) const
  {
    std::array<ParameterBox, 2> both{{*this, *this}};
    both[0].high[d] = both[1].low[d] = center()[d];
    for (ParameterBox &half : both)
      ++half.bisections[d];
    return both;
  }



  void
  ForceRange::add(const Tensor<1, 3> &f)
  {
    for (unsigned int c = 0; c < 3; ++c)
      {
        low[c]  = empty ? f[c] : std::min(low[c], f[c]);
        high[c] = empty ? f[c] : std::max(high[c], f[c]);
      }
    empty = false;
  }



  double
  ForceRange::beyond(const Tensor<1, 3> &f) const
  {
    double most = 0.;
    for (unsigned int c = 0; c < 3; ++c)
      {
        const double margin = new_value * (high[c] - low[c]) +
                              arithmetic::rounding_of_solutions *
                                std::max(std::abs(low[c]), std::abs(high[c]));
        most =
          std::max({most, low[c] - margin - f[c], f[c] - high[c] - margin});
      }
    return most;
  }



  template <int dim>
  MomentRule<dim>::MomentRule(const Cell              &cell,
                              const ParameterBox<dim> &box,
                              const unsigned int       more)
    : cell(cell)
  {
    for (unsigned int d = 0; d < dim; ++d)
      {
        const QGauss<1> gauss(cell.degree[d] + 3 + more);
        for (unsigned int q = 0; q < gauss.size(); ++q)
          {
            const double h = box.high[d] - box.low[d];
            x[d].push_back(box.low[d] + gauss.point(q)[0] * h);
            w[d].push_back(gauss.weight(q) * h);
            const std::size_t known = phi[d].size();
            phi[d].resize(known + cell.degree[d] + 1);
            GaussLobattoBasis::of_degree(cell.degree[d])
              .evaluate(x[d].back(), phi[d].data() + known, nullptr);
          }
        points *= x[d].size();
        functions *= cell.degree[d] + 1;
      }
  }



  template <int dim>
  typename MomentRule<dim>::Node
  MomentRule<dim>::node(const unsigned int q) const
  {
    Node         node;
    unsigned int rest = q;
    for (unsigned int d = 0; d < dim; ++d)
      {
        node.at[d] = rest % x[d].size();
        rest /= x[d].size();
        node.point[d] = x[d][node.at[d]];
        node.weight *= w[d][node.at[d]];
      }
    return node;
  }



  template <int dim>
  double
  MomentRule<dim>::weighted(const Node &node, const unsigned int k) const
  {
    double       value = node.weight;
    unsigned int rest  = k;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const unsigned int n = cell.degree[d] + 1;
        value *= phi[d][node.at[d] * n + rest % n];
        rest /= n;
      }
    return value;
  }



  template <int dim>
  std::vector<Tensor<1, 3>>
  MomentRule<dim>::integrate(ForceRange &range) const
  {
    std::vector<Tensor<1, 3>> moments(functions);
    for (unsigned int q = 0; q < points; ++q)
      {
        const Node         here = node(q);
        const Tensor<1, 3> f    = cell.f(here.point);
        range.add(f);
        for (unsigned int k = 0; k < functions; ++k)
          moments[k] += weighted(here, k) * f;
      }
    return moments;
  }



  template struct ParameterBox<1>;
  template struct ParameterBox<2>;
  template class MomentRule<1>;
  template class MomentRule<2>;
} // namespace lamella
