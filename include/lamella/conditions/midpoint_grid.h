// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_midpoint_grid_h
#define lamella_conditions_midpoint_grid_h

#include <lamella/conditions/moment_rule.h>

#include <array>
#include <vector>

namespace lamella
{
  /// Values of a load f at the midpoints of a regular grid over a cell, which
  /// detect features of f between Gauss points (adaptive_moments()). All cells
  /// together have about 2e4 points; a cell has at least four per parameter.
  template <int dim>
  class MidpointGrid
  {
  public:
    /// A cell of the load, with its force f.
    using Cell = typename Moments<dim>::Cell;

    /// Evaluates the load on @p cell, one of @p n_cells cells, with @p finer
    /// times the usual number of points along each parameter.
    MidpointGrid(const Cell       &cell,
                 const std::size_t n_cells,
                 const double      finer);

    /// Returns the load at the midpoints, the first parameter running fastest.
    const std::vector<dealii::Tensor<1, 3>> &
    values() const
    {
      return kept;
    }

    /// Returns the largest value of ForceRange::beyond() at grid points in @p
    /// box; @p range are the values of the load at the Gauss points of the box.
    double
    beyond(const ParameterBox<dim> &box, const ForceRange &range) const;

  private:
    /// Number of points along each parameter.
    std::array<unsigned int, dim>     n;
    std::vector<dealii::Tensor<1, 3>> kept;
  };
} // namespace lamella

#endif
