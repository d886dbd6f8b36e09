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
  /// Result of inverse_image(), which inverts a map x(u) of the unit cube.
  template <int dim>
  struct InverseImage
  {
    /// Last iterate u of the Newton iteration; may be outside of the unit cube.
    dealii::Point<dim> unit;
    /// Length of the last Newton step in reference coordinates u: below 1e-14
    /// if the iteration converged, large if x(u) = x has no solution.
    double change = std::numeric_limits<double>::max();
  };

  /// Solves x(u) = x for a map x(u) of the unit cube by Newton's method,
  ///   u <- u + (dx/du)^-1 (x - x(u)),
  /// from @p start until the step is below 1e-14, for at most 20 steps. Throws
  /// no exception: the caller must check the residual or InverseImage::change.
  /// A singular Jacobian gives NaN.
  ///
  /// @param start initial u
  /// @param is_affine whether x(u) is affine, so that one step is exact
  /// @param missing returns the residual x - x(u) and the Jacobian dx/du at u
  /// @param keep called with each new u, which it may modify, e.g. clip to the
  /// cube; returns whether to continue
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

  /// Clips each coordinate of @p unit to [-0.5, 1.5] and returns true. To be
  /// used as the parameter `keep` of inverse_image().
  template <int dim>
  bool
  clip_to_neighborhood(dealii::Point<dim> &unit)
  {
    for (unsigned int d = 0; d < dim; ++d)
      unit[d] = std::min(1.5, std::max(-0.5, unit[d]));
    return true;
  }
} // namespace lamella

#endif
