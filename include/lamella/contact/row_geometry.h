// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_row_geometry_h
#define lamella_contact_row_geometry_h

#include <lamella/body/body.h>

#include <utility>
#include <vector>

namespace lamella
{
  /**
   * What the rows of a contact were made from on one side of it: row r is
   *   sum_k w_rk . u(X_k)
   * over the places X_k, for whatever displacement field u the body has. So the
   * same body in another discretisation can be given the same gaps, and be
   * loaded with the same contact forces (rows_on()).
   */
  struct RowGeometry
  {
    using Weights = std::vector<std::pair<unsigned int, dealii::Tensor<1, 3>>>;

    std::vector<Location> places;
    /// Of each row, by numbers of places.
    std::vector<Weights> weights;
  };
} // namespace lamella

#endif
