// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_row_geometry_h
#define lamella_contact_row_geometry_h

#include <lamella/base/row.h>
#include <lamella/body/body.h>

#include <utility>
#include <vector>

namespace lamella
{
  /**
   * The geometry of the gap rows on one side of a contact, free of any
   * discretisation of the body: row r is
   *   sum_k w_rk . u(X_k)
   * over the places X_k, for whatever displacement field u the body has. A gap
   * function needs no more of a body than that; B of the DoFs is W times the
   * displacement rows of Body::rows(). So the same body in another
   * discretisation can be given the same gaps, and be loaded with the same
   * contact forces; a body that has moved, gaps about where it is now.
   *
   * For pairs of points a row has one place and its weight is -n on First or n
   * on Second; for weighted gaps the places are the trace nodes of the facets
   * around, and the weights 1/A_i int phi_i psi_k n dA, psi_k the trace
   * functions.
   */
  struct RowGeometry
  {
    /// Of one row: pairs of k and w_rk (no unit, scene axes).
    using Weights = std::vector<std::pair<unsigned int, dealii::Tensor<1, 3>>>;

    /// The X_k, in cells of the body that the contact was made from.
    std::vector<Location> places;
    /// Of each row, by numbers of places. As many as rows, in their order; none
    /// on an obstacle's side.
    std::vector<Weights> weights;
  };

  /**
   * The rows of @p side as functionals of the DoFs of the body number @p index,
   *   B = W R,  row r: sum_k sum_c w_rk,c R_kc,
   * with @p at the three displacement rows R_k of each place, as Body::rows()
   * gives them: of the body that the contact was made from, or of the same body
   * in another discretisation. As many as side.weights.
   */
  std::vector<BodyRow>
  body_rows(const unsigned int                   index,
            const DofIndex                       n_dofs,
            const std::vector<std::vector<Row>> &at,
            const RowGeometry                   &side);
} // namespace lamella

#endif
