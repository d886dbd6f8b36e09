// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/conditions/adaptive_moments.h>
#include <lamella/conditions/midpoint_grid.h>
#include <lamella/conditions/moment_rule.h>

#include <algorithm>

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
    // What the grid's sum may be off by before it is asked how sure it is.
    constexpr double little = 0.01;



    /// A box with its moments, their error, and the parameter to bisect along.
    template <int dim>
    struct Piece
    {
      unsigned int       cell = 0;
      ParameterBox<dim>  box;
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
      {}

      Moments<dim>
      run();

    private:
      using Cell = typename Moments<dim>::Cell;

      void
      make_grid(const Cell &cell);
      /// The sum of all f on a grid of its own.
      Force
      sum_on_grid(const double finer);
      void
      assess_grid();
      /// How far values at the edges of a box are beyond those inside, and how
      /// much they vary from the middle along each parameter.
      struct Edges
      {
        double                  beyond = 0.;
        std::array<double, dim> variation{};
      };
      Edges
      sample_edges(const Cell              &cell,
                   const ParameterBox<dim> &box,
                   const ForceRange        &range);
      /// The moments over a box by Gauss' rule, see MomentRule.
      std::vector<Force>
      rule(const Cell              &cell,
           const ParameterBox<dim> &box,
           const unsigned int       more,
           ForceRange              &range);
      /// How far the halves of a piece are from the whole, along the parameter
      /// where they are furthest, which becomes its direction.
      double
      bisection_error(Piece<dim> &piece);
      /// Parameter to bisect if halves see nothing: varying, else longer.
      unsigned int
      choose_bisection_direction(const Edges      &edges,
                                 const Piece<dim> &piece) const;
      Piece<dim>
      piece(const unsigned int number, const ParameterBox<dim> &box);
      void
      add(std::vector<Piece<dim>> &heap, Piece<dim> &&piece);
      void
      bisect_worst(std::vector<Piece<dim>> &heap);

      const std::vector<Cell>       &cells;
      const bool                     constant;
      std::vector<MidpointGrid<dim>> grids;
      double                         evaluations = 0.;
      Moments<dim>                   result;
    };



    template <int dim>
    void
    Integration<dim>::make_grid(const Cell &cell)
    {
      grids.emplace_back(cell, cells.size(), 1.);
      const std::vector<Force> &values   = grids.back().values();
      const unsigned int        n_points = values.size();
      for (const Force &f : values)
        {
          result.size += f.norm() / n_points;
          result.independent += f / n_points;
        }
      evaluations += n_points;
    }



    template <int dim>
    Force
    Integration<dim>::sum_on_grid(const double finer)
    {
      Force sum;
      for (const Cell &cell : cells)
        {
          const MidpointGrid<dim> grid(cell, cells.size(), finer);
          const unsigned int      n_points = grid.values().size();
          for (const Force &f : grid.values())
            sum += f / n_points;
          evaluations += n_points;
        }
      return sum;
    }



    /// A grid knows edges to its own spacing only: where it contradicts the
    /// rule, others tell how far it is to be believed.
    template <int dim>
    void
    Integration<dim>::assess_grid()
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



    /// The corners of @p box and the middles of its sides (no Gauss points).
    template <int dim>
    typename Integration<dim>::Edges
    Integration<dim>::sample_edges(const Cell              &cell,
                                   const ParameterBox<dim> &box,
                                   const ForceRange        &range)
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
    Integration<dim>::rule(const Cell              &cell,
                           const ParameterBox<dim> &box,
                           const unsigned int       more,
                           ForceRange              &range)
    {
      const MomentRule<dim> gauss(cell, box, more);
      evaluations += gauss.n_points();
      return gauss.integrate(range);
    }



    template <int dim>
    double
    Integration<dim>::bisection_error(Piece<dim> &piece)
    {
      double most = -1.;
      for (unsigned int d = 0; d < dim; ++d)
        {
          std::vector<Force> sum(piece.moments.size());
          for (const ParameterBox<dim> &half : piece.box.halves(d))
            {
              ForceRange               range;
              const std::vector<Force> one =
                rule(cells[piece.cell], half, 0, range);
              for (unsigned int k = 0; k < sum.size(); ++k)
                sum[k] += one[k];
            }
          const double gain = difference(piece.moments, sum);
          if (gain > most)
            {
              most            = gain;
              piece.direction = d;
            }
        }
      return most;
    }



    template <int dim>
    unsigned int
    Integration<dim>::choose_bisection_direction(const Edges      &edges,
                                                 const Piece<dim> &piece) const
    {
      const Cell              &cell = cells[piece.cell];
      const ParameterBox<dim> &box  = piece.box;
      const double             s = cell.extent[0] * (box.high[0] - box.low[0]);
      const double             t =
        cell.extent[dim - 1] * (box.high[dim - 1] - box.low[dim - 1]);
      const double along_s = edges.variation[0];
      const double along_t = edges.variation[dim - 1];
      return along_s != along_t ? along_t > along_s : t > s;
    }



    template <int dim>
    Piece<dim>
    Integration<dim>::piece(const unsigned int       number,
                            const ParameterBox<dim> &box)
    {
      const Cell &cell = cells[number];
      ForceRange  range;
      Piece<dim>  result;
      result.cell    = number;
      result.box     = box;
      result.moments = rule(cell, box, 0, range);
      if (constant)
        return result;
      const Edges  edges = sample_edges(cell, box, range);
      const double missed =
        std::max(grids[number].beyond(box, range), edges.beyond) * box.volume();
      const std::vector<Force> finer = rule(cell, box, 1, range);
      result.error                   = difference(result.moments, finer);
      if (missed <= 0. && result.error <= 0.01 * tolerance * this->result.size)
        {
          result.moments = finer;
          return result;
        }
      // Which way to cut, and how wrong the whole is: what its halves say,
      // unless there is what they do not see, either.
      const double most = bisection_error(result);
      if (dim == 2 && most < missed)
        result.direction = choose_bisection_direction(edges, result);
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
      for (const ParameterBox<dim> &half : halves)
        add(heap, piece(worst.cell, half));
      if (halves[0].bisections[worst.direction] > result.bisections)
        {
          result.bisections = halves[0].bisections[worst.direction];
          result.cell       = worst.cell;
          result.place      = worst.box.center();
        }
    }



    template <int dim>
    Moments<dim>
    Integration<dim>::run()
    {
      std::vector<Piece<dim>> heap;
      ParameterBox<dim>       unit;
      for (unsigned int d = 0; d < dim; ++d)
        unit.high[d] = 1.;
      if (!constant)
        for (const Cell &cell : cells)
          make_grid(cell);
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
        assess_grid();
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
