// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_gauss_lobatto_grid_h
#define lamella_base_gauss_lobatto_grid_h

#include <lamella/base/gauss_lobatto_basis.h>

#include <deal.II/base/point.h>

#include <vector>

namespace lamella
{
  /// Returns the points (s_i, t_j) of the tensor-product grid of the bases @p s
  /// and @p t on the unit square. The first index varies fastest.
  std::vector<dealii::Point<2>>
  grid_points(const GaussLobattoBasis &s, const GaussLobattoBasis &t);

  /// Evaluates the products L_i(s) L_j(t) of the polynomials @p s and @p t at
  /// the point @p st, and stores them in @p values, ordered as by
  /// grid_points().
  void
  evaluate_on_grid(const GaussLobattoBasis &s,
                   const GaussLobattoBasis &t,
                   const dealii::Point<2>  &st,
                   std::vector<double>     &values);
} // namespace lamella

#endif
