// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_constraint_geometry_h
#define lamella_contact_constraint_geometry_h

#include <lamella/base/linear_functional.h>
#include <lamella/body/body.h>

#include <utility>
#include <vector>

namespace lamella
{
  /**
   * Geometry of the gap rows on one side of a contact, independent of the
   * discretization of the body: row r is
   *   sum_k w_rk . u(X_k)
   * over the places X_k, for any displacement field u. B is W times the
   * displacement rows of Body::rows(), so another discretization of the same
   * body can use the same gaps and contact forces, as can a displaced body. For
   * pairs of points a row has one place, with the weight -n on First or n on
   * Second; for weighted gaps the places are the trace nodes of the facets
   * around, with the weights 1/A_i int phi_i psi_k n dA, psi_k their functions.
   */
  struct ConstraintGeometry
  {
    /// Pairs of k and w_rk of one row (no unit, scene axes).
    using Weights = std::vector<std::pair<unsigned int, dealii::Tensor<1, 3>>>;

    /// Places X_k, in cells of the body that the contact was made from.
    std::vector<Location> places;
    /// Weights of each row, by numbers of places; empty for an obstacle.
    std::vector<Weights> weights;
  };

  /// Returns the rows of @p side as functionals of the DoFs of body number @p
  /// index,
  ///   B = W R,  row r: sum_k sum_c w_rk,c R_kc,
  /// with the three displacement rows R_k of each place in @p at, from
  /// Body::rows() of any discretization of the body.
  std::vector<BodyFunctional>
  body_rows(const unsigned int                                index,
            const DofIndex                                    n_dofs,
            const std::vector<std::vector<LinearFunctional>> &at,
            const ConstraintGeometry                         &side);
} // namespace lamella

#endif
