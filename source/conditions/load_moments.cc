// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/conditions/load.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Of all cells: points at first, evaluations for bisections at most.
    constexpr double first_points = 2e4, most_evaluations = 2e6;
    // Of one cell along a parameter, at first.
    constexpr double most_along = 4e3;



    /// A part of a cell with its integrals by Gauss rules.
    struct Box
    {
      unsigned int              cell = 0;
      std::array<double, 2>     low{}, high{{1., 1.}};
      std::vector<Tensor<1, 3>> moments;
      double                    size = 0., error = 0.; ///< As LoadMoments.
      unsigned int direction = 0; ///< Parameter with the larger error.

      bool
      operator<(const Box &other) const
      {
        return error < other.error;
      }
    };



    /// Returns the sum of |a_k - b_k|.
    double
    difference(const std::vector<Tensor<1, 3>> &a,
               const std::vector<Tensor<1, 3>> &b)
    {
      double sum = 0.;
      for (std::size_t k = 0; k < a.size(); ++k)
        sum += (a[k] - b[k]).norm();
      return sum;
    }



    /// Returns rules for polynomials of degree @p p on [0, 1]: the Gauss rule,
    /// and the Gauss-Lobatto rule with its end points just inside, where the
    /// load belongs to this interval. Degree 0 is across a line: one point.
    std::array<Quadrature<1>, 2>
    rules_of(const unsigned int p)
    {
      if (p == 0)
        return {{QGauss<1>(1), QGauss<1>(1)}};
      const QGaussLobatto<1> closed(p + 4);
      std::vector<Point<1>>  points = closed.get_points();
      points.front()[0]             = arithmetic::same_position;
      points.back()[0]              = 1. - arithmetic::same_position;
      return {{QGauss<1>(p + 3), Quadrature<1>(points, closed.get_weights())}};
    }



    /// The composite rules over all cells.
    class Integration
    {
    public:
      explicit Integration(const std::vector<LoadCell> &cells)
        : cells(cells)
      {
        for (const LoadCell &cell : cells)
          for (const unsigned int p : cell.degree)
            if (rules.count(p) == 0)
              rules[p] = rules_of(p);
      }

      LoadMoments
      run()
      {
        std::vector<std::vector<Tensor<1, 3>>> plain;
        for (unsigned int c = 0; c < cells.size(); ++c)
          {
            Box whole;
            whole.cell = c;
            plain.push_back(moments(whole, {{0, 0}}, whole.size));
            result.of_cells.emplace_back(plain.back().size());
          }
        for (unsigned int c = 0; c < cells.size(); ++c)
          divide(c);
        evaluations = 0.;
        while (result.error > arithmetic::negligible * result.size &&
               evaluations < most_evaluations)
          bisect_worst();
        for (; !boxes.empty(); boxes.pop())
          for (unsigned int k = 0; k < boxes.top().moments.size(); ++k)
            result.of_cells[boxes.top().cell][k] += boxes.top().moments[k];
        for (unsigned int c = 0; c < cells.size(); ++c)
          {
            const double error = difference(plain[c], result.of_cells[c]);
            if (error > result.unresolved)
              {
                result.unresolved = error;
                result.cell       = c;
              }
          }
        return result;
      }

    private:
      using Rule = std::array<unsigned int, 2>; ///< 0: Gauss, 1: Gauss-Lobatto.

      /// Returns the moments over @p box by the @p rule of each parameter, and
      /// adds the integral of |f| to @p size.
      std::vector<Tensor<1, 3>>
      moments(const Box &box, const Rule &rule, double &size)
      {
        const LoadCell                    &cell = cells[box.cell];
        std::array<std::vector<double>, 2> phi, weight, x;
        for (unsigned int d = 0; d < 2; ++d)
          {
            const unsigned int   p     = cell.degree[d];
            const Quadrature<1> &of_d  = rules[p][rule[d]];
            const double         width = box.high[d] - box.low[d];
            phi[d].assign(of_d.size() * (p + 1), 1.);
            for (unsigned int q = 0; q < of_d.size(); ++q)
              {
                x[d].push_back(box.low[d] + of_d.point(q)[0] * width);
                weight[d].push_back(of_d.weight(q) * width);
                if (p > 0)
                  GaussLobattoBasis::of_degree(p).evaluate(x[d][q],
                                                           &phi[d][q * (p + 1)],
                                                           nullptr);
              }
          }
        const unsigned int n_s = cell.degree[0] + 1, n_t = cell.degree[1] + 1;
        std::vector<Tensor<1, 3>> sum(n_s * n_t);
        for (unsigned int r = 0; r < x[1].size(); ++r)
          for (unsigned int q = 0; q < x[0].size(); ++q)
            {
              const Tensor<1, 3> f =
                weight[0][q] * weight[1][r] * cell.f({x[0][q], x[1][r]});
              size += f.norm();
              for (unsigned int k = 0; k < sum.size(); ++k)
                sum[k] +=
                  phi[0][q * n_s + k % n_s] * phi[1][r * n_t + k / n_s] * f;
            }
        evaluations += x[0].size() * x[1].size();
        return sum;
      }

      /// Returns @p box with moments and error.
      Box
      evaluated(Box box)
      {
        double other = 0.;
        box.size     = 0.;
        box.moments  = moments(box, {{0, 0}}, box.size);
        box.error    = difference(box.moments, moments(box, {{1, 1}}, other));
        if (cells[box.cell].degree[1] > 0)
          box.direction =
            difference(box.moments, moments(box, {{0, 1}}, other)) >
            difference(box.moments, moments(box, {{1, 0}}, other));
        return box;
      }

      /// Divides cell number @p c into its first boxes.
      void
      divide(const unsigned int c)
      {
        const LoadCell       &cell   = cells[c];
        const double          points = first_points / cells.size();
        std::array<double, 2> n{{points, 1.}};
        if (cell.degree[1] > 0)
          for (unsigned int d = 0; d < 2; ++d)
            n[d] = std::sqrt(points * cell.extent[d] / cell.extent[1 - d]);
        for (unsigned int d = 0; d < 2; ++d)
          n[d] = std::max(1.,
                          std::ceil(std::min(most_along, n[d]) /
                                    (2 * cell.degree[d] + 7)));
        for (double j = 0.; j < n[1]; ++j)
          for (double i = 0.; i < n[0]; ++i)
            {
              Box box;
              box.cell = c;
              box.low  = {{i / n[0], j / n[1]}};
              box.high = {{(i + 1.) / n[0], (j + 1.) / n[1]}};
              add(evaluated(box));
            }
      }

      void
      add(Box box)
      {
        result.size += box.size;
        result.error += box.error;
        boxes.push(std::move(box));
      }

      void
      bisect_worst()
      {
        Box                box = boxes.top();
        const unsigned int d   = box.direction;
        boxes.pop();
        result.size -= box.size;
        result.error -= box.error;
        const double middle = 0.5 * (box.low[d] + box.high[d]),
                     high   = box.high[d];
        box.high[d]         = middle;
        add(evaluated(box));
        box.low[d]  = middle;
        box.high[d] = high;
        add(evaluated(box));
      }

      const std::vector<LoadCell> &cells;
      /// Rules by polynomial degree.
      std::map<unsigned int, std::array<Quadrature<1>, 2>> rules;
      std::priority_queue<Box>                             boxes;
      double                                               evaluations = 0.;
      LoadMoments                                          result;
    };
  } // namespace



  LoadMoments
  load_moments(const std::vector<LoadCell> &cells)
  {
    return Integration(cells).run();
  }
} // namespace lamella
