// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/conditions/midpoint_grid.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Points in all, and at least along each parameter of a cell.
    constexpr double       grid_points = 2e4;
    constexpr unsigned int least_grid = 4, most_grid = 4000;



    /// Points along each parameter of a cell, one of @p n_cells.
    template <int dim>
    std::array<unsigned int, dim>
    points_along(const std::array<double, dim> &extent,
                 const std::size_t              n_cells,
                 const double                   finer)
    {
      const double each = std::pow(grid_points / n_cells, 1. / dim);
      double       mean = 1.;
      for (unsigned int d = 0; d < dim; ++d)
        mean *= std::pow(extent[d], 1. / dim);
      std::array<unsigned int, dim> n{};
      for (unsigned int d = 0; d < dim; ++d)
        n[d] = finer * std::min<double>(
                         most_grid,
                         std::max<double>(least_grid,
                                          each * std::sqrt(extent[d] / mean)));
      return n;
    }
  } // namespace



  template <int dim>
  MidpointGrid<dim>::MidpointGrid(const Cell       &cell,
                                  const std::size_t n_cells,
                                  const double      finer)
    : n(points_along<dim>(cell.extent, n_cells, finer))
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
        kept.push_back(cell.f(x));
      }
  }



  template <int dim>
  double
  MidpointGrid<dim>::beyond(const ParameterBox<dim> &box,
                            const ForceRange        &range) const
  {
    std::array<unsigned int, dim> begin, end;
    for (unsigned int d = 0; d < dim; ++d)
      {
        begin[d] = std::ceil(box.low[d] * n[d] - 0.5);
        end[d]   = std::min<double>(n[d], std::ceil(box.high[d] * n[d] - 0.5));
      }
    double most = 0.;
    for (unsigned int j = dim == 2 ? begin[dim - 1] : 0;
         j < (dim == 2 ? end[dim - 1] : 1);
         ++j)
      for (unsigned int i = begin[0]; i < end[0]; ++i)
        most = std::max(most, range.beyond(kept[j * n[0] + i]));
    return most;
  }



  template class MidpointGrid<1>;
  template class MidpointGrid<2>;
} // namespace lamella
