// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_adaptive_moments_h
#define lamella_conditions_adaptive_moments_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <functional>
#include <vector>

namespace lamella
{
  /// Integrals over the cells of a load: a vector function f on the unit
  /// interval (dim 1) or square (dim 2) times products phi_k of Lagrange
  /// polynomials at Gauss-Lobatto points,
  ///   moment_k = integral f phi_k,
  /// for tractions and trace functions the consistent nodal forces.
  template <int dim>
  struct Moments
  {
    /// A cell with its integrand, on a facet times the area per unit square.
    struct Cell
    {
      /// Force per unit of the parameters, finite inside the cell.
      std::function<dealii::Tensor<1, 3>(const dealii::Point<dim> &)> f;
      /// Degrees, at least 1, of the polynomials along each parameter.
      std::array<unsigned int, dim> degree{};
      /// Lengths of the cell along each parameter. Only ratios matter.
      std::array<double, dim> extent{};
    };

    /// Moments of_cells[c][k] of cell c, the first parameter running fastest: k
    /// = k_t (degree_s + 1) + k_s.
    std::vector<std::vector<dealii::Tensor<1, 3>>> of_cells;
    /// Sum of integral |f|, and the estimated error of the integrals, which
    /// excludes features that no point of rule and grid has met.
    double size = 0., error = 0.;
    /// Sum of all f by midpoints on a separate grid of about 2e4 points in all.
    dealii::Tensor<1, 3> independent;
    /// Largest difference of `independent` from three finer grids, computed if
    /// it differs from the sum of moments by more than 1 % of the size, else 0.
    double independent_error = 0.;
    /// Bisections of the cell bisected most along one parameter, its number,
    /// and the place; zero if there were none.
    unsigned int       bisections = 0, cell = 0;
    dealii::Point<dim> place;
  };

  /**
   * Integrates by Gauss rules of degree + 3 points per parameter. Bisects the
   * piece of largest error first, along the parameter that gains most, until
   * the sum of errors is below 1e-9 of the size. Pieces are also bisected where
   * a finer grid of midpoints has values that the rule has not met; its sum is
   * the independent check. Stops at 1e6 evaluations with the remaining error
   * (as at edges across a surface oblique to its parameters).
   *
   * With @p constant all f are assumed smooth: no grid and no bisection.
   *
   * The error of a piece is estimated by Gauss rules of degree + 3 and + 4
   * points, by its halves along each parameter if they differ, and by values
   * just inside its edges. A piece is bisected at most 45 times along a
   * parameter, the resolution of doubles. Pieces are in a heap by error.
   */
  template <int dim>
  Moments<dim>
  adaptive_moments(const std::vector<typename Moments<dim>::Cell> &cells,
                   const bool                                      constant);
} // namespace lamella

#endif
