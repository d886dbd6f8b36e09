// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/conditions/adaptive_moments.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    using Force = Tensor<1, 3>;

    // Of the integral of |f|.
    constexpr double tolerance        = 1e-9;
    constexpr double most_evaluations = 1e6;
    // Of one parameter: what doubles can tell apart.
    constexpr unsigned int most_bisections = 45;
    // Of the grid that looks for what the rule misses: points in all, and at
    // least along each parameter of a cell.
    constexpr double       grid_points = 2e4;
    constexpr unsigned int least_grid = 4, most_grid = 4000;
    // Values this share of their range beyond it are new: between Gauss points
    // and the edges of their cell a polynomial goes on.
    constexpr double new_value = 0.25;
    // What the grid's sum may be off by before it is asked how sure it is.
    constexpr double little = 0.01;



    template <int dim>
    struct Box
    {
      Point<dim>                    low, high;
      std::array<unsigned int, dim> bisections{};

      double
      volume() const
      {
        double v = 1.;
        for (unsigned int d = 0; d < dim; ++d)
          v *= high[d] - low[d];
        return v;
      }

      Point<dim>
      centre() const
      {
        return low + 0.5 * (high - low);
      }

      std::array<Box, 2>
      halves(const unsigned int d) const
      {
        std::array<Box, 2> both{{*this, *this}};
        both[0].high[d] = both[1].low[d] = centre()[d];
        for (Box &half : both)
          ++half.bisections[d];
        return both;
      }
    };



    /// A box with its moments, the error that it may have, and the parameter
    /// to bisect it along.
    template <int dim>
    struct Piece
    {
      unsigned int       cell = 0;
      Box<dim>           box;
      std::vector<Force> moments;
      double             error     = 0.;
      unsigned int       direction = 0;

      bool
      operator<(const Piece &other) const
      {
        return error < other.error;
      }
    };



    double
    difference(const std::vector<Force> &a, const std::vector<Force> &b)
    {
      double largest = 0.;
      for (unsigned int k = 0; k < a.size(); ++k)
        largest = std::max(largest, (a[k] - b[k]).norm());
      return largest;
    }



    template <int dim>
    class Integration
    {
    public:
      Integration(const std::vector<typename Moments<dim>::Cell> &cells,
                  const bool                                      constant)
        : cells(cells)
        , constant(constant)
        , grids(cells.size())
      {}

      Moments<dim>
      run();

    private:
      using Cell = typename Moments<dim>::Cell;

      /// The smallest and the largest value of each component.
      struct Range
      {
        Force low, high;
        bool  empty = true;

        void
        add(const Force &f)
        {
          for (unsigned int c = 0; c < 3; ++c)
            {
              low[c]  = empty ? f[c] : std::min(low[c], f[c]);
              high[c] = empty ? f[c] : std::max(high[c], f[c]);
            }
          empty = false;
        }

        /// How far @p f is from what is known.
        double
        beyond(const Force &f) const
        {
          double most = 0.;
          for (unsigned int c = 0; c < 3; ++c)
            {
              const double margin =
                new_value * (high[c] - low[c]) +
                arithmetic::rounding_of_solutions *
                  std::max(std::abs(low[c]), std::abs(high[c]));
              most = std::max(
                {most, low[c] - margin - f[c], f[c] - high[c] - margin});
            }
          return most;
        }
      };

      /// Values at the midpoints of a grid over a cell.
      struct Grid
      {
        std::array<unsigned int, dim> n{};
        std::vector<Force>            values;
      };

      /// Points along each parameter of a cell: as many on each cell, more
      /// along its longer side, @p finer times those of the grid.
      std::array<unsigned int, dim>
      points_along(const Cell &cell, const double finer) const;
      /// Calls @p use with the value at the midpoint of each part, and their
      /// number.
      template <typename Use>
      void
      for_each_midpoint(const Cell                          &cell,
                        const std::array<unsigned int, dim> &n,
                        const Use                           &use);
      void
      make_grid(const unsigned int cell);
      /// The sum of all f on a grid of its own.
      Force
      sum_on_grid(const double finer);
      void
      judge_grid();
      double
      unseen(const unsigned int cell,
             const Box<dim>    &box,
             const Range       &range) const;
      /// How far values at the edges of a box are beyond those inside, and how
      /// much they vary from the middle along each parameter.
      struct Edges
      {
        double                  beyond = 0.;
        std::array<double, dim> variation{};
      };
      Edges
      look_at_edges(const Cell &cell, const Box<dim> &box, const Range &range);
      std::vector<Force>
      rule(const Cell        &cell,
           const Box<dim>    &box,
           const unsigned int more,
           Range             &range);
      Piece<dim>
      piece(const unsigned int cell, const Box<dim> &box);
      void
      add(std::vector<Piece<dim>> &heap, Piece<dim> &&piece);
      void
      bisect_worst(std::vector<Piece<dim>> &heap);

      const std::vector<Cell> &cells;
      const bool               constant;
      std::vector<Grid>        grids;
      double                   evaluations = 0.;
      Moments<dim>             result;
    };



    template <int dim>
    std::array<unsigned int, dim>
    Integration<dim>::points_along(const Cell &cell, const double finer) const
    {
      const double each = std::pow(grid_points / cells.size(), 1. / dim);
      double       mean = 1.;
      for (unsigned int d = 0; d < dim; ++d)
        mean *= std::pow(cell.extent[d], 1. / dim);
      std::array<unsigned int, dim> n{};
      for (unsigned int d = 0; d < dim; ++d)
        n[d] =
          finer * std::min<double>(
                    most_grid,
                    std::max<double>(least_grid,
                                     each * std::sqrt(cell.extent[d] / mean)));
      return n;
    }



    template <int dim>
    template <typename Use>
    void
    Integration<dim>::for_each_midpoint(const Cell &cell,
                                        const std::array<unsigned int, dim> &n,
                                        const Use &use)
    {
      unsigned int n_points = 1;
      for (unsigned int d = 0; d < dim; ++d)
        n_points *= n[d];
      for (unsigned int k = 0; k < n_points; ++k)
        {
          Point<dim>   x;
          unsigned int rest = k;
          for (unsigned int d = 0; d < dim; ++d)
            {
              x[d] = (rest % n[d] + 0.5) / n[d];
              rest /= n[d];
            }
          use(cell.f(x), n_points);
        }
      evaluations += n_points;
    }



    template <int dim>
    void
    Integration<dim>::make_grid(const unsigned int number)
    {
      Grid &grid = grids[number];
      grid.n     = points_along(cells[number], 1.);
      for_each_midpoint(cells[number],
                        grid.n,
                        [&](const Force &f, const unsigned int n_points) {
                          grid.values.push_back(f);
                          result.size += f.norm() / n_points;
                          result.independent += f / n_points;
                        });
    }



    template <int dim>
    Force
    Integration<dim>::sum_on_grid(const double finer)
    {
      Force sum;
      for (const Cell &cell : cells)
        for_each_midpoint(cell,
                          points_along(cell, finer),
                          [&sum](const Force &f, const unsigned int n_points) {
                            sum += f / n_points;
                          });
      return sum;
    }



    /// A grid knows edges to its own spacing only: where it contradicts the
    /// rule, others tell how far it is to be believed.
    template <int dim>
    void
    Integration<dim>::judge_grid()
    {
      Force all;
      for (const std::vector<Force> &moments : result.of_cells)
        for (const Force &moment : moments)
          all += moment;
      if ((result.independent - all).norm() <= little * result.size)
        return;
      for (const double finer : {1.31, 1.73, 2.29})
        result.independent_error =
          std::max(result.independent_error,
                   (sum_on_grid(finer) - result.independent).norm());
    }



    /// How far values of the grid in @p box are beyond @p range.
    template <int dim>
    double
    Integration<dim>::unseen(const unsigned int cell,
                             const Box<dim>    &box,
                             const Range       &range) const
    {
      const Grid                   &grid = grids[cell];
      std::array<unsigned int, dim> begin, end;
      for (unsigned int d = 0; d < dim; ++d)
        {
          begin[d] = std::ceil(box.low[d] * grid.n[d] - 0.5);
          end[d]   = std::min<double>(grid.n[d],
                                    std::ceil(box.high[d] * grid.n[d] - 0.5));
        }
      double most = 0.;
      for (unsigned int j = dim == 2 ? begin[dim - 1] : 0;
           j < (dim == 2 ? end[dim - 1] : 1);
           ++j)
        for (unsigned int i = begin[0]; i < end[0]; ++i)
          most = std::max(most, range.beyond(grid.values[j * grid.n[0] + i]));
      return most;
    }



    /// Likewise of values at the edges of @p box, which no Gauss point is on:
    /// at the middles of its sides and at its corners.
    template <int dim>
    typename Integration<dim>::Edges
    Integration<dim>::look_at_edges(const Cell     &cell,
                                    const Box<dim> &box,
                                    const Range    &range)
    {
      // Just inside: the edge itself may be another element's.
      constexpr double inside = 1e-7;
      const auto       value  = [&](const std::array<double, 2> &t) {
        Point<dim> x;
        for (unsigned int d = 0; d < dim; ++d)
          x[d] = box.low[d] + t[d] * (box.high[d] - box.low[d]);
        evaluations += 1.;
        return cell.f(x);
      };
      Edges       edges;
      const Force middle = value({{0.5, 0.5}});
      for (const double a : {inside, 1. - inside})
        {
          for (unsigned int d = 0; d < dim; ++d)
            {
              const Force side = value({{d == 0 ? a : 0.5, d == 1 ? a : 0.5}});
              edges.beyond     = std::max(edges.beyond, range.beyond(side));
              edges.variation[d] =
                std::max(edges.variation[d], (side - middle).norm());
            }
          for (const double b : {inside, 1. - inside})
            edges.beyond =
              std::max(edges.beyond, range.beyond(value({{a, b}})));
        }
      return edges;
    }



    template <int dim>
    std::vector<Force>
    Integration<dim>::rule(const Cell        &cell,
                           const Box<dim>    &box,
                           const unsigned int more,
                           Range             &range)
    {
      // Points and functions of each parameter, once.
      std::array<std::vector<double>, dim> x, w, phi;
      unsigned int                         n_points = 1, n_functions = 1;
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
          n_points *= x[d].size();
          n_functions *= cell.degree[d] + 1;
        }
      std::vector<Force> moments(n_functions);
      for (unsigned int q = 0; q < n_points; ++q)
        {
          std::array<unsigned int, dim> at;
          Point<dim>                    point;
          double                        weight = 1.;
          unsigned int                  rest   = q;
          for (unsigned int d = 0; d < dim; ++d)
            {
              at[d] = rest % x[d].size();
              rest /= x[d].size();
              point[d] = x[d][at[d]];
              weight *= w[d][at[d]];
            }
          const Force f = cell.f(point);
          range.add(f);
          for (unsigned int k = 0; k < n_functions; ++k)
            {
              double       value = weight;
              unsigned int other = k;
              for (unsigned int d = 0; d < dim; ++d)
                {
                  const unsigned int n = cell.degree[d] + 1;
                  value *= phi[d][at[d] * n + other % n];
                  other /= n;
                }
              moments[k] += value * f;
            }
        }
      evaluations += n_points;
      return moments;
    }



    template <int dim>
    Piece<dim>
    Integration<dim>::piece(const unsigned int number, const Box<dim> &box)
    {
      const Cell &cell = cells[number];
      Range       range;
      Piece<dim>  result;
      result.cell    = number;
      result.box     = box;
      result.moments = rule(cell, box, 0, range);
      if (constant)
        return result;
      const Edges  edges = look_at_edges(cell, box, range);
      const double missed =
        std::max(unseen(number, box, range), edges.beyond) * box.volume();
      const std::vector<Force> finer = rule(cell, box, 1, range);
      result.error                   = difference(result.moments, finer);
      if (missed <= 0. && result.error <= 0.01 * tolerance * this->result.size)
        {
          result.moments = finer;
          return result;
        }
      // Which way to cut, and how wrong the whole is: what its halves say.
      double most = -1.;
      for (unsigned int d = 0; d < dim; ++d)
        {
          std::vector<Force> sum(result.moments.size());
          for (const Box<dim> &half : box.halves(d))
            {
              const std::vector<Force> one = rule(cell, half, 0, range);
              for (unsigned int k = 0; k < sum.size(); ++k)
                sum[k] += one[k];
            }
          const double gain = difference(result.moments, sum);
          if (gain > most)
            {
              most             = gain;
              result.direction = d;
            }
        }
      // What halves do not see, either: along the parameter that it varies
      // with, else the longer way.
      if (dim == 2 && most < missed)
        {
          const double s = cell.extent[0] * (box.high[0] - box.low[0]),
                       t = cell.extent[dim - 1] *
                           (box.high[dim - 1] - box.low[dim - 1]),
                       along_s = edges.variation[0],
                       along_t = edges.variation[dim - 1];
          result.direction = (along_s != along_t ? along_t > along_s : t > s);
        }
      result.error = std::max({result.error, most, missed});
      return result;
    }



    template <int dim>
    void
    Integration<dim>::add(std::vector<Piece<dim>> &heap, Piece<dim> &&piece)
    {
      result.error += piece.error;
      heap.push_back(std::move(piece));
      std::push_heap(heap.begin(), heap.end());
    }



    template <int dim>
    void
    Integration<dim>::bisect_worst(std::vector<Piece<dim>> &heap)
    {
      std::pop_heap(heap.begin(), heap.end());
      const Piece<dim> worst = std::move(heap.back());
      heap.pop_back();
      result.error -= worst.error;
      const auto halves = worst.box.halves(worst.direction);
      for (const Box<dim> &half : halves)
        add(heap, piece(worst.cell, half));
      if (halves[0].bisections[worst.direction] > result.bisections)
        {
          result.bisections = halves[0].bisections[worst.direction];
          result.cell       = worst.cell;
          result.place      = worst.box.centre();
        }
    }



    template <int dim>
    Moments<dim>
    Integration<dim>::run()
    {
      std::vector<Piece<dim>> heap;
      Box<dim>                unit;
      for (unsigned int d = 0; d < dim; ++d)
        unit.high[d] = 1.;
      for (unsigned int c = 0; c < cells.size() && !constant; ++c)
        make_grid(c);
      for (unsigned int c = 0; c < cells.size(); ++c)
        add(heap, piece(c, unit));
      while (!heap.empty() && result.error > tolerance * result.size &&
             evaluations < most_evaluations &&
             *std::max_element(heap.front().box.bisections.begin(),
                               heap.front().box.bisections.end()) <
               most_bisections)
        bisect_worst(heap);

      result.of_cells.resize(cells.size());
      for (const Piece<dim> &piece : heap)
        {
          auto &sum = result.of_cells[piece.cell];
          sum.resize(piece.moments.size());
          for (unsigned int k = 0; k < sum.size(); ++k)
            sum[k] += piece.moments[k];
        }
      if (!constant)
        judge_grid();
      return std::move(result);
    }
  } // namespace



  template <int dim>
  Moments<dim>
  adaptive_moments(const std::vector<typename Moments<dim>::Cell> &cells,
                   const bool                                      constant)
  {
    return Integration<dim>(cells, constant).run();
  }



  template Moments<1>
  adaptive_moments<1>(const std::vector<Moments<1>::Cell> &, const bool);
  template Moments<2>
  adaptive_moments<2>(const std::vector<Moments<2>::Cell> &, const bool);
} // namespace lamella
