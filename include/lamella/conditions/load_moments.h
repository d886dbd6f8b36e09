// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_load_moments_h
#define lamella_conditions_load_moments_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <functional>
#include <vector>

namespace lamella
{
  /// A load on a piece of a line (interval [0, 1] of s) or on a surface facet
  /// (unit square of s, t).
  struct LoadCell
  {
    /// Force f per unit interval or square, finite inside the cell: on a facet,
    /// the traction times the area element dA / (ds dt).
    std::function<dealii::Tensor<1, 3>(const dealii::Point<2> &)> f;
    /// Degrees of the polynomials along s and t; 0 along t for a line.
    std::array<unsigned int, 2> degree;
    /// Lengths of the cell along s and t; only their ratio is used.
    std::array<double, 2> extent;
  };

  /// Integrals of a load f over cells. phi_k are products of Lagrange
  /// polynomials through Gauss-Lobatto points:
  ///   moment_k = integral f phi_k
  /// These are consistent nodal forces if f is a traction.
  struct LoadMoments
  {
    /// Moments of_cells[c][k] of cell c and polynomial k, the first parameter s
    /// running fastest: k = k_t (degree_s + 1) + k_s.
    std::vector<std::vector<dealii::Tensor<1, 3>>> of_cells;
    double size  = 0., ///< Integral of |f| over all cells [force].
      error      = 0., ///< Estimated error of all moments together [force].
      unresolved = 0.; ///< Largest error of one Gauss rule per cell [force].
    unsigned int cell = 0; ///< Index of the cell with the error `unresolved`.
  };

  /// Returns the moments of the loads on @p cells by composite Gauss rules. A
  /// cell is divided into boxes with degree + 3 points along each parameter; at
  /// first, all cells together have about 2e4 points. The error of a box is the
  /// difference from the Gauss-Lobatto rules of degree + 4 points. The box with
  /// the largest error is bisected, along the parameter with the larger error,
  /// until the sum of errors is below 1e-9 of LoadMoments::size, or until f has
  /// been evaluated another 2e6 times. Peaks of f that no point hits are
  /// missed.
  LoadMoments
  load_moments(const std::vector<LoadCell> &cells);
} // namespace lamella

#endif
