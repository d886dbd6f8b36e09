// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_inverse_map_h
#define lamella_base_inverse_map_h

#include <lamella/base/arithmetic.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace lamella
{
  /// Where a map takes a place that was asked for, as far as it is known.
  template <int dim>
  struct InverseImage
  {
    /// u, the last iterate. Where the place lies outside of the cube's image it
    /// is the continuation of the map, as far as @p keep let it go.
    dealii::Point<dim> unit;
    /// The length of the last step: rounding if the place was found. In unit
    /// coordinates, a pure number. Zero for an affine map, whose only step is
    /// exact. What stayed large says that the map does not reach the place.
    double change = std::numeric_limits<double>::max();
  };

  /**
   * Newton's method for the u at which a map x(u) of the unit cube takes the
   * value x, from @p start. @p missing(u) returns x - x(u) and the Jacobian
   * dx/du as a pair of tensors; @p keep(u) may bring u back from far outside of
   * the cube, where a curved map may fold, and ends the search by returning
   * false. An affine map takes one step. (deal.II's Mapping inverts the maps of
   * its own cells; these are of sections, of columns through them, and of the
   * facets that rays meet.)
   *
   *   u <- u + (dx/du)^-1 (x - x(u))
   *
   * until the step is below 1e-14 or 20 steps are done. Convergence is
   * quadratic for the mildly curved cells of sections; the caller judges the
   * result by its residual or by change. Nothing is thrown: a singular Jacobian
   * gives values that are no numbers.
   *
   * @param is_affine whether x(u) is affine, so that one step ends it
   * @param missing   u -> (x - x(u), dx/du), both in the same unit of length
   * @param keep      u -> whether to go on; may change u
   */
  template <int dim, typename Missing, typename Keep>
  InverseImage<dim>
  inverse_image(const dealii::Point<dim> &start,
                const bool                is_affine,
                const Missing            &missing,
                const Keep               &keep)
  {
    constexpr unsigned int max_iterations = 20;

    InverseImage<dim> found{start};
    for (unsigned int k = 0; k < max_iterations; ++k)
      {
        const std::pair<dealii::Tensor<1, dim>, dealii::Tensor<2, dim>> at =
          missing(found.unit);
        const dealii::Tensor<1, dim> step = invert(at.second) * at.first;
        found.unit += step;
        found.change = is_affine ? 0. : step.norm();
        if (!keep(found.unit) || is_affine ||
            found.change < arithmetic::rounding)
          break;
      }
    return found;
  }

  /// Brings @p unit back to half a cube's side around the unit cube. Into
  /// [-0.5, 1.5] in each coordinate, and true: Newton's method goes on from
  /// there. What lies further out is reported as if it were at that border.
  template <int dim>
  bool
  stay_near(dealii::Point<dim> &unit)
  {
    for (unsigned int d = 0; d < dim; ++d)
      unit[d] = std::min(1.5, std::max(-0.5, unit[d]));
    return true;
  }
} // namespace lamella

#endif
