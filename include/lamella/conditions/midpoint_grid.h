// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_midpoint_grid_h
#define lamella_conditions_midpoint_grid_h

#include <lamella/conditions/moment_rule.h>

#include <array>
#include <vector>

namespace lamella
{
  /// The midpoint rule on a grid over a cell of a load, which detects features
  /// between Gauss points (adaptive_moments()): about 2e4 points in all,
  /// equally many per cell, at least four per parameter.
  template <int dim>
  class MidpointGrid
  {
  public:
    using Cell = typename Moments<dim>::Cell;

    /// Evaluates f over @p cell, one of @p n_cells; @p finer multiplies points.
    MidpointGrid(const Cell       &cell,
                 const std::size_t n_cells,
                 const double      finer);

    /// Returns f at the midpoints, the first parameter running fastest.
    const std::vector<dealii::Tensor<1, 3>> &
    values() const
    {
      return kept;
    }

    /// Returns how far values in @p box exceed @p range (ForceRange::beyond()).
    double
    beyond(const ParameterBox<dim> &box, const ForceRange &range) const;

  private:
    /// Number of points along each parameter.
    std::array<unsigned int, dim>     n;
    std::vector<dealii::Tensor<1, 3>> kept;
  };
} // namespace lamella

#endif
