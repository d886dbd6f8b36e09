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
  ///   moment_k = integral f phi_k
  /// These are consistent nodal forces if f is a traction.
  template <int dim>
  struct Moments
  {
    /// A cell with its integrand f. On a facet, f is the traction times the
    /// area element dA / (ds dt).
    struct Cell
    {
      /// Force per unit interval or square; must be finite inside the cell.
      std::function<dealii::Tensor<1, 3>(const dealii::Point<dim> &)> f;
      /// Degrees, at least 1, of the polynomials along each parameter.
      std::array<unsigned int, dim> degree{};
      /// Lengths of the cell along each parameter; only their ratio is used.
      std::array<double, dim> extent{};
    };

    /// Moments of_cells[c][k] of cell c and polynomial k, the first parameter s
    /// running fastest: k = k_t (degree_s + 1) + k_s.
    std::vector<std::vector<dealii::Tensor<1, 3>>> of_cells;
    /// Integral of |f| over all cells [force].
    double size = 0., error = 0.; ///< Estimated error of the integrals [force].
    /// Integral of f over all cells by the midpoint rule with 2e4 points.
    dealii::Tensor<1, 3> independent;
    /// Error of `independent`: its largest difference from midpoint rules on
    /// three finer grids; 0 if it agrees with the moments to 1 % of `size`.
    double independent_error = 0.;
    /// Largest number of bisections of a cell along one of its parameters.
    unsigned int bisections = 0,
                 cell       = 0; ///< Index of the cell with most bisections.
    dealii::Point<dim> place; ///< Parameters of the point with most bisections.
  };

  /// Integrates the loads f on @p cells by Gauss rules of degree + 3 points per
  /// parameter. Each cell is a box at first. The box of largest error is
  /// bisected, along the parameter that reduces the error most, until the sum
  /// of errors is below 1e-9 of Moments::size. A box is also bisected if values
  /// of f on a regular grid of midpoints are outside the range of its values at
  /// the Gauss points of the box. The integration ends after 1e6 evaluations,
  /// with the remaining error in Moments::error. If @p constant is true, all f
  /// are assumed smooth: no midpoint grid is evaluated and no box is bisected.
  ///
  /// The error of a box is estimated by Gauss rules of degree + 3 and degree +
  /// 4 points, by the halves of the box if these rules differ, and by values
  /// just inside its edges. Peaks of f that no evaluation point hits are
  /// missed. A box is bisected at most 45 times along a parameter (resolution
  /// of doubles).
  template <int dim>
  Moments<dim>
  adaptive_moments(const std::vector<typename Moments<dim>::Cell> &cells,
                   const bool                                      constant);
} // namespace lamella

#endif
