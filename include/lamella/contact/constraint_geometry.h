// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_constraint_geometry_h
#define lamella_contact_constraint_geometry_h

#include <lamella/base/linear_functional.h>
#include <lamella/body/body.h>

#include <utility>
#include <vector>

namespace lamella
{
  /// Weights and points of the gap constraints on one side of a contact,
  /// independent of the discretization of the body. Constraint r is
  ///   sum_k w_rk . u(X_k)
  /// for a displacement field u and points X_k. Its row in the constraint
  /// matrix is the product of the weights w_rk and the displacement rows of
  /// Body::rows(), so another discretization of the same body, or the deformed
  /// body, can use the same gaps and contact forces. A node pair has one point
  /// per side, with the weight -n on the first and n on the second, n the
  /// normal. A weighted gap has the trace nodes of its facets, with weights
  /// 1/A_i int phi_i psi_k n dA: phi_i is the multiplier function, A_i its
  /// integral, psi_k the displacement shape function of the node.
  struct ConstraintGeometry
  {
    /// Pairs (index in `places`, weight vector) of one constraint, scene axes.
    using Weights = std::vector<std::pair<unsigned int, dealii::Tensor<1, 3>>>;

    /// Points in the body for which the contact was created.
    std::vector<Location> places;
    /// Weights of each constraint; empty for an obstacle.
    std::vector<Weights> weights;
  };

  /// Returns the constraints of @p side as functionals of the @p n_dofs DoFs of
  /// the body with index @p index: row r is sum_k sum_c w_rk,c R_kc with the
  /// weights w_rk of @p side. @p at has the three displacement rows R_kc of
  /// each point k, from Body::rows() of any discretization of the body.
  std::vector<BodyFunctional>
  body_rows(const unsigned int                                index,
            const DofIndex                                    n_dofs,
            const std::vector<std::vector<LinearFunctional>> &at,
            const ConstraintGeometry                         &side);
} // namespace lamella

#endif
