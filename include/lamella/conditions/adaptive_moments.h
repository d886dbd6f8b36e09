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
  /// Integrals of a distributed load over its cells. f is the load on the unit
  /// interval (dim 1) or square (dim 2) of a cell; phi_k are products of
  /// Lagrange polynomials through Gauss-Lobatto points:
  ///   moment_k = integral f phi_k,
  /// These are consistent nodal forces if f is a traction.
  template <int dim>
  struct Moments
  {
    /// A cell with its integrand f. On a facet, f is the traction times the
    /// area per unit square.
    struct Cell
    {
      /// Force per unit interval or square; must be finite inside the cell.
      std::function<dealii::Tensor<1, 3>(const dealii::Point<dim> &)> f;
      /// Degrees, at least 1, of the polynomials along each parameter.
      std::array<unsigned int, dim> degree{};
      /// Lengths of the cell along each parameter; only their ratio is used.
      std::array<double, dim> extent{};
    };

    /// Moments of_cells[c][k] of cell c, the first parameter running fastest: k
    /// = k_t (degree_s + 1) + k_s.
    std::vector<std::vector<dealii::Tensor<1, 3>>> of_cells;
    /// Sum of integral |f| over all cells, and the estimated error of the
    /// integrals. The estimate misses peaks of f between all evaluation points.
    double size = 0., error = 0.;
    /// Integral of f over all cells by the midpoint rule, 2e4 points in total.
    dealii::Tensor<1, 3> independent;
    /// Largest difference between `independent` and its values on three finer
    /// grids; 0 (not computed) if it agrees with the moments to 1 % of `size`.
    double independent_error = 0.;
    /// Largest number of bisections along one parameter, and the cell and the
    /// point (parameters) where they occurred; zero without bisections.
    unsigned int       bisections = 0, cell = 0;
    dealii::Point<dim> place;
  };

  /// Integrates the loads f on @p cells by Gauss rules of degree + 3 points per
  /// parameter. Each cell is a box at first. The box of largest error is
  /// bisected, along the parameter that reduces the error most, until the sum
  /// of errors is below 1e-9 of Moments::size. A box is also bisected if values
  /// on a finer midpoint grid are outside the range of values at its Gauss
  /// points. The integration ends after 1e6 evaluations, with the remaining
  /// error in Moments::error.
  ///
  /// If @p constant is true, all f are assumed smooth: no midpoint grid is
  /// evaluated and no box is bisected.
  ///
  /// The error of a box is estimated by Gauss rules of degree + 3 and degree +
  /// 4 points, by the halves of the box if these rules differ, and by values
  /// just inside its edges. A box is bisected at most 45 times along a
  /// parameter (resolution of doubles).
  template <int dim>
  Moments<dim>
  adaptive_moments(const std::vector<typename Moments<dim>::Cell> &cells,
                   const bool                                      constant);
} // namespace lamella

#endif
