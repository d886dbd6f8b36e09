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
  /**
   * Integrals over the cells of a load. In each cell a vector function f (three
   * components) on the unit interval (dim 1, lines) or square (dim 2, facets)
   * is integrated with products phi_k of Lagrange polynomials at Gauss-Lobatto
   * points,
   *   moment_k = integral f phi_k.
   * If f is a traction and phi_k are trace functions, these are the forces of a
   * consistent load vector.
   */
  template <int dim>
  struct Moments
  {
    /// A cell with its integrand. On a facet f includes the area per unit of
    /// the square, so that integrals over the unit square are forces.
    struct Cell
    {
      /// f, force per unit of the parameters. It is evaluated inside the cell
      /// only, and must be finite there.
      std::function<dealii::Tensor<1, 3>(const dealii::Point<dim> &)> f;
      /// Degrees of the Lagrange polynomials along each parameter, with degree
      /// + 1 functions each; at least 1.
      std::array<unsigned int, dim> degree{};
      /// Lengths of the cell along each parameter. Only ratios matter.
      std::array<double, dim> extent{};
    };

    /// Moments of_cells[c][k] of cell c, phi_0 of the first parameter running
    /// fastest; with two parameters k = k_t (degree_s + 1) + k_s.
    std::vector<std::vector<dealii::Tensor<1, 3>>> of_cells;
    /// sum of integral |f|, and the estimated error of the integrals, both in
    /// the unit of f. The error is no bound: it excludes features that no point
    /// of rule and grid has met.
    double size = 0., error = 0.;
    /// Sum of all f by another rule: midpoints on a separate grid of about 2e4
    /// points in all, at least four along each parameter of a cell.
    dealii::Tensor<1, 3> independent;
    /// Estimated error of `independent`: the largest difference from three
    /// finer grids. Computed if it differs from the sum of all moments by more
    /// than 1 % of the size, else 0.
    double independent_error = 0.;
    /// Bisections of the cell bisected most, along one parameter, its number,
    /// and the place. Zero, with the origin of the unit square, if there were
    /// none.
    unsigned int       bisections = 0, cell = 0;
    dealii::Point<dim> place;
  };

  /**
   * Integrates by Gauss rules of degree + 3 points per parameter, exact for
   * polynomials. Bisects the piece of largest error first, along the parameter
   * that gains most, until the sum of errors is below 1e-9 of the size. A finer
   * grid of midpoints detects features between the Gauss points: pieces are
   * bisected where the grid has values that the rule has not met, and its sum
   * is the independent check. Stops at 1e6 evaluations with the remaining error
   * (as at edges across a surface oblique to its parameters).
   *
   * With @p constant all f are assumed smooth: no grid, no bisection, and only
   * the moments in the result.
   *
   * The error of a piece is estimated by Gauss rules of degree + 3 and + 4
   * points, by its halves along each parameter if they differ, and by values
   * just inside its edges. A piece is bisected at most 45 times along a
   * parameter, the resolution of doubles. Pieces are kept in a heap by error: a
   * step costs the logarithm of their number and the evaluations of two halves.
   */
  template <int dim>
  Moments<dim>
  adaptive_moments(const std::vector<typename Moments<dim>::Cell> &cells,
                   const bool                                      constant);
} // namespace lamella

#endif
