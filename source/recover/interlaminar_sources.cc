// SPDX-License-Identifier: LGPL-2.1-or-later

// What stresses by equilibrium integrate: derivatives of the in-plane stresses
// in a column, less what free edges take off.

#include <lamella/base/arithmetic.h>
#include <lamella/recover/interlaminar.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lamella
{
  using namespace dealii;

  std::vector<double>
  EquilibriumStress::points_of(const Quadrature<1> &rule)
  {
    std::vector<double> result;
    for (const Point<1> &point : rule.get_points())
      result.push_back(point[0]);
    return result;
  }



  namespace
  {
    /// The weights of the values at @p points that make derivatives at @p at,
    /// the 0th to the @p most-th, of the polynomial of @p degree that is
    /// fitted to them by least squares.
    std::vector<std::vector<double>>
    derivative_weights(const std::vector<double> &points,
                       const unsigned int         degree,
                       const double               at,
                       const unsigned int         most)
    {
      // Legendre polynomials of the interval from the first to the last point
      // are nearly orthogonal over Gauss points: no digits are lost.
      const auto [low, high] =
        std::minmax_element(points.begin(), points.end());
      const double origin = *low,
                   length =
                     std::max(*high - *low, arithmetic::smallest_divisor);
      const unsigned int               n = degree + 1;
      std::vector<std::vector<double>> values(points.size());
      std::vector<std::vector<double>> here(n);
      for (unsigned int k = 0; k < n; ++k)
        {
          const Polynomials::Legendre polynomial(k);
          for (unsigned int i = 0; i < points.size(); ++i)
            values[i].push_back(
              polynomial.value((points[i] - origin) / length));
          here[k].resize(most + 1);
          polynomial.value((at - origin) / length, most, here[k].data());
        }
      FullMatrix<double> normal(n, n);
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int l = 0; l < n; ++l)
          for (const auto &row : values)
            normal(k, l) += row[k] * row[l];
      normal.gauss_jordan();
      std::vector<std::vector<double>> weights(
        most + 1, std::vector<double>(points.size(), 0.));
      for (unsigned int m = 0; m <= most; ++m)
        for (unsigned int i = 0; i < points.size(); ++i)
          for (unsigned int k = 0; k < n; ++k)
            for (unsigned int l = 0; l < n; ++l)
              weights[m][i] +=
                values[i][k] * normal(k, l) * here[l][m] / std::pow(length, m);
      return weights;
    }



    /// The first and the last of the elements between @p breaks that hold the
    /// place @p at: two, if they meet there.
    std::pair<unsigned int, unsigned int>
    elements_at(const std::vector<double> &breaks, const double at)
    {
      // Of the ratio to an element's length.
      constexpr double   same  = arithmetic::same_in_element;
      const unsigned int n     = breaks.size() - 1;
      unsigned int       first = n, last = 0;
      for (unsigned int k = 0; k < n; ++k)
        {
          const double near = same * (breaks[k + 1] - breaks[k]);
          if (at >= breaks[k] - near && at <= breaks[k + 1] + near)
            {
              first = std::min(first, k);
              last  = std::max(last, k);
            }
        }
      return {first, last};
    }



    // Of Sampled.
    constexpr unsigned int s_xx = 0, s_yy = 1, s_xy = 2, g_xz = 3, g_yz = 4;
  } // namespace



  EquilibriumStress::Stencil
  EquilibriumStress::stencil(const unsigned int d,
                             const Point<3>    &through) const
  {
    constexpr unsigned int least = 3, most_derivatives = 4;

    Point<3> begin = through, end = through;
    begin[d]         = 0.;
    end[d]           = box.size[d];
    const Point<3> a = box.frame.to_scene(begin), b = box.frame.to_scene(end);
    const std::vector<double> breaks = body.line_breaks(a, b);
    const unsigned int        n      = breaks.size() - 1;
    const double              at     = through[d] / box.size[d];
    auto [first, last]               = elements_at(breaks, at);
    const unsigned int p             = body.cells().recovery_degrees[d];
    const bool         is_smooth     = p == 0;
    unsigned int       degree        = body.line_degree(a, b);
    if (!is_smooth)
      {
        // Neighbors, and at ends as many elements as elsewhere.
        first  = first == 0 ? 0 : first - 1;
        last   = std::min(last + 1, n - 1);
        first  = std::min(first, last + 1 - std::min(last + 1, least));
        last   = std::max(last, std::min(n, first + least) - 1);
        degree = d == 1 ? p + 1 : p;
      }
    const QGauss<1> gauss(is_smooth ? degree + 1 : p);
    Stencil         result;
    result.at = through[d];
    for (unsigned int k = first; k <= last; ++k)
      for (const double t : points_of(gauss))
        result.points.push_back(box.size[d] *
                                (breaks[k] + t * (breaks[k + 1] - breaks[k])));
    degree = std::min<unsigned int>(degree, result.points.size() - 1);
    result.weights =
      derivative_weights(result.points, degree, through[d], most_derivatives);
    return result;
  }



  EquilibriumStress::Sources
  EquilibriumStress::sources(const std::vector<Layer> &layers,
                             const double              x,
                             const double              y)
  {
    const unsigned int size = layers.size() * nodes.size();
    Sources            all;
    for (Profile &profile : all.shear)
      profile.reinit(2 * size);
    for (Profile &profile : all.strain)
      profile.reinit(2 * size);
    all.normal.reinit(size);
    const std::vector<FreeEdgeCorrection> edges_here =
      free_edge_corrections(layers, x, y);
    for (unsigned int k = 0; k < layers.size(); ++k)
      {
        const Point<3> middle(x, y, 0.5 * (layers[k].bottom + layers[k].top));
        add_sources(k,
                    layers[k],
                    edges_here,
                    stencil(0, middle),
                    stencil(1, middle),
                    all);
      }
    return all;
  }



  const EquilibriumStress::Sampled &
  EquilibriumStress::sampled_at(const Point<3> &x, const unsigned int ply)
  {
    const double        unit = arithmetic::same_position * box.size.norm();
    std::array<long, 3> key;
    for (unsigned int d = 0; d < 3; ++d)
      key[d] = std::lround(x[d] / unit);
    const auto [known, is_new] = sampled.try_emplace(key);
    if (is_new)
      {
        const auto here = body.locate({box.frame.to_scene(x)}).front();
        const auto location =
          std::find_if(here.begin(), here.end(), [ply](const Location &l) {
            return l.ply == ply;
          });
        AssertThrow(location != here.end(), ExcInternalError());
        const FieldSample sample = body.sample(*location, u);
        const Voigt       stress = transpose(to_scene) * sample.stress,
                    strain       = to_body * sample.strain;
        known->second            = {
                     {stress[xx], stress[yy], stress[xy], strain[xz], strain[yz]}};
      }
    return known->second;
  }



  EquilibriumStress::FreeEdgeDecay
  EquilibriumStress::free_edge_decay(const unsigned int side,
                                     const double       x) const
  {
    // sinh((W - d) / l) / sinh(W / l), d from the side, without overflow.
    const double W    = box.size[0] / decay,
                 d    = (side == 0 ? x : box.size[0] - x) / decay,
                 size = std::exp(-d) / -std::expm1(-2. * W),
                 back = std::exp(-2. * (W - d));
    return {size * (1. - back),
            (side == 0 ? -1. : 1.) * size * (1. + back) / decay};
  }



  const std::vector<Tensor<1, 5>> &
  EquilibriumStress::free_edge_stress(const unsigned int        side,
                                      const std::vector<Layer> &layers,
                                      const double              y)
  {
    const double unit = arithmetic::same_position * box.size.norm();
    const auto [known, is_new] =
      edges.try_emplace({{long(side), std::lround(y / unit)}});
    if (!is_new)
      return known->second;
    Tensor<1, 5> mean;
    for (const Layer &layer : layers)
      {
        const double   thickness = layer.top - layer.bottom;
        const Point<3> edge(side * box.size[0],
                            y,
                            0.5 * (layer.bottom + layer.top));
        const Stencil  along_x = stencil(0, edge), along_y = stencil(1, edge);
        for (unsigned int q = 0; q < samples.size(); ++q)
          {
            const double z = layer.bottom + samples[q] * thickness;
            Tensor<1, 5> stress;
            for (unsigned int i = 0; i < along_x.points.size(); ++i)
              for (unsigned int j = 0; j < along_y.points.size(); ++j)
                for (unsigned int b = 0; b < 5; ++b)
                  stress[b] +=
                    along_x.weights[0][i] * along_y.weights[b][j] *
                    sampled_at({along_x.points[i], along_y.points[j], z},
                               layer.ply)[2];
            known->second.push_back(stress);
            mean += thickness / box.size[2] * sample_weights[q] * stress;
          }
      }
    for (Tensor<1, 5> &stress : known->second)
      stress -= mean;
    return known->second;
  }



  std::vector<EquilibriumStress::FreeEdgeCorrection>
  EquilibriumStress::free_edge_corrections(const std::vector<Layer> &layers,
                                           const double              x,
                                           const double              y)
  {
    constexpr double                nothing = arithmetic::rounding_of_results;
    std::vector<FreeEdgeCorrection> shares(layers.size() * samples.size());
    for (const unsigned int side : {0, 1})
      {
        const FreeEdgeDecay shape = free_edge_decay(side, x);
        if (!is_free[side] || std::abs(shape.slope) * decay < nothing)
          continue;
        const auto &stress = free_edge_stress(side, layers, y);
        for (unsigned int k = 0; k < shares.size(); ++k)
          {
            shares[k].of_value += shape.value * stress[k];
            shares[k].of_slope += shape.slope * stress[k];
          }
      }
    return shares;
  }



  EquilibriumStress::Derivatives
  EquilibriumStress::derivatives_at(const double       z,
                                    const unsigned int ply,
                                    const Stencil     &along_x,
                                    const Stencil     &along_y,
                                    double            &in_plane)
  {
    Derivatives d;
    for (unsigned int i = 0; i < along_x.points.size(); ++i)
      for (unsigned int j = 0; j < along_y.points.size(); ++j)
        {
          const Sampled &values =
            sampled_at({along_x.points[i], along_y.points[j], z}, ply);
          for (const unsigned int c : {s_xx, s_yy, s_xy})
            in_plane = std::max(in_plane, std::abs(values[c]));
          for (unsigned int a = 0; a < 3; ++a)
            for (unsigned int b = 0; b < 5; ++b)
              for (unsigned int c = 0; c < 5; ++c)
                d[a][b][c] +=
                  along_x.weights[a][i] * along_y.weights[b][j] * values[c];
        }
    return d;
  }



  void
  EquilibriumStress::add_sources(
    const unsigned int                     k,
    const Layer                           &layer,
    const std::vector<FreeEdgeCorrection> &edges_here,
    const Stencil                         &along_x,
    const Stencil                         &along_y,
    Sources                               &all)
  {
    const unsigned int n = nodes.size(), size = all.normal.size();
    for (unsigned int q = 0; q < samples.size(); ++q)
      {
        const double z = layer.bottom + samples[q] * (layer.top - layer.bottom);
        // d[a][b] is the derivative a times along x and b times along y.
        Derivatives d =
          derivatives_at(z, layer.ply, along_x, along_y, all.in_plane);
        const FreeEdgeCorrection &edge = edges_here[k * samples.size() + q];
        for (unsigned int b = 0; b < 5; ++b)
          {
            d[0][b][s_xy] -= edge.of_value[b];
            d[1][b][s_xy] -= edge.of_slope[b];
          }
        for (unsigned int i = 0; i < n; ++i)
          {
            const double       w  = to_nodes(i, q);
            const unsigned int of = k * n + i;
            for (unsigned int m = 0; m < 4; ++m)
              {
                all.shear[m][of] -= w * (d[1][m][s_xx] + d[0][m + 1][s_xy]);
                all.shear[m][size + of] -=
                  w * (d[1][m][s_xy] + d[0][m + 1][s_yy]);
              }
            all.normal[of] -=
              w * (d[2][0][s_xx] + 2. * d[1][1][s_xy] + d[0][2][s_yy]);
            for (unsigned int m = 0; m < 2; ++m)
              {
                all.strain[m][of] += w * d[0][m + 2][g_xz];
                all.strain[m][size + of] += w * d[0][m + 2][g_yz];
              }
          }
      }
  }
} // namespace lamella
