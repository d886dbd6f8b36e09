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
   * What is known of integrals over the cells of a load: each a vector function
   * f on the unit square (or interval), integrated with the products phi_k of
   * Lagrange polynomials at Gauss-Lobatto points,
   *   moment_k = integral f phi_k.
   * With a traction for f and the trace functions for phi_k these are the
   * forces of a consistent load vector. Vector means three components; dim is 1
   * along a line and 2 on a facet.
   */
  template <int dim>
  struct Moments
  {
    /// A cell and what is asked of it. For a facet f holds the area per unit of
    /// the square, so that integrals over the unit square are forces.
    struct Cell
    {
      /// f: force per unit of the parameters. It is evaluated inside the cell
      /// only, and must be finite there.
      std::function<dealii::Tensor<1, 3>(const dealii::Point<dim> &)> f;
      /// Of the Lagrange polynomials along each parameter. degree + 1 functions
      /// each, at least 1.
      std::array<unsigned int, dim> degree{};
      /// Lengths of the cell along each parameter, for what is as wide as high.
      /// Only ratios matter; any unit.
      std::array<double, dim> extent{};
    };

    /// Of each cell, phi_0 of the first parameter running fastest.
    /// of_cells[c][k]; in two parameters k = k_t (degree_s + 1) + k_s.
    std::vector<std::vector<dealii::Tensor<1, 3>>> of_cells;
    /// sum of integral |f|, and what the integrals may be off by. Both in the
    /// unit of f. The error is an estimate and no bound: what no point of rule
    /// and grid has met is not in it.
    double size = 0., error = 0.;
    /// The sum of all f by another rule than the one above: the midpoint rule
    /// on a grid of its own. About 2e4 points in all, at least four along each
    /// parameter of a cell.
    dealii::Tensor<1, 3> independent;
    /// What that sum may be off by, as far as three finer grids tell: the
    /// largest difference to theirs. Looked at where it is more than 1 % of the
    /// size off the sum of all moments, else 0.
    double independent_error = 0.;
    /// Of the cell that was bisected most: how often along one parameter, its
    /// number, and where. Zero if nothing was bisected; place then is the
    /// origin of the unit square.
    unsigned int       bisections = 0, cell = 0;
    dealii::Point<dim> place;
  };

  /**
   * Integrates by Gauss' rule of degree + 3 points a parameter, exact for what
   * is polynomial, and bisects where halves do not agree with the whole: the
   * worst place first, along the parameter that gains most, until all errors
   * together are below 1e-9 of the size. What falls between the points of the
   * rule is seen by a finer grid of midpoints, which bisects where it finds
   * values that the rule has not met, and whose own sum is the independent
   * check. Ends at 1e6 evaluations with the error that is left (edges across a
   * surface that are not along its parameters).
   *
   * With @p constant all f are taken to be smooth: no grid, no bisection, and
   * nothing but the moments in the result.
   *
   * A piece is judged by two Gauss rules of degree + 3 and + 4 points, by its
   * halves along each parameter where they disagree, and by values at its edges
   * just inside. No piece is bisected more than 45 times along a parameter,
   * which is what doubles can tell apart. Pieces stand in a heap by their
   * error, so a step costs the logarithm of their number and the evaluations of
   * two halves.
   */
  template <int dim>
  Moments<dim>
  adaptive_moments(const std::vector<typename Moments<dim>::Cell> &cells,
                   const bool                                      constant);
} // namespace lamella

#endif
