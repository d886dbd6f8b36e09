// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_gauss_lobatto_grid_h
#define lamella_base_gauss_lobatto_grid_h

#include <lamella/base/gauss_lobatto_basis.h>

#include <deal.II/base/point.h>

#include <vector>

namespace lamella
{
  /// Returns the nodes (s_i, t_j) of the tensor-product grid of two bases on
  /// the unit square. The index i of the first coordinate runs fastest.
  std::vector<dealii::Point<2>>
  grid_points(const GaussLobattoBasis &s, const GaussLobattoBasis &t);

  /// Evaluates the shape functions L_i(s) L_j(t) of the grid_points() at the
  /// point @p st, in the same order, and stores them in @p values.
  void
  evaluate_on_grid(const GaussLobattoBasis &s,
                   const GaussLobattoBasis &t,
                   const dealii::Point<2>  &st,
                   std::vector<double>     &values);
} // namespace lamella

#endif
