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
   */
  template <int dim>
  struct Moments
  {
    /// A cell and what is asked of it.
    struct Cell
    {
      /// f: force per unit of the parameters.
      std::function<dealii::Tensor<1, 3>(const dealii::Point<dim> &)> f;
      /// Of the Lagrange polynomials along each parameter.
      std::array<unsigned int, dim> degree{};
      /// Lengths of the cell along each parameter, for what is as wide as high.
      std::array<double, dim> extent{};
    };

    /// Of each cell, phi_0 of the first parameter running fastest.
    std::vector<std::vector<dealii::Tensor<1, 3>>> of_cells;
    /// sum of integral |f|, and what the integrals may be off by.
    double size = 0., error = 0.;
    /// The sum of all f by another rule than the one above: the midpoint rule
    /// on a grid of its own.
    dealii::Tensor<1, 3> independent;
    /// Of the cell that was bisected most: how often along one parameter, its
    /// number, and where.
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
   */
  template <int dim>
  Moments<dim>
  adaptive_moments(const std::vector<typename Moments<dim>::Cell> &cells,
                   const bool                                      constant);
} // namespace lamella

#endif
