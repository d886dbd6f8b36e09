// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_gauss_lobatto_grid_h
#define lamella_base_gauss_lobatto_grid_h

#include <lamella/base/gauss_lobatto_basis.h>

#include <deal.II/base/point.h>

#include <vector>

namespace lamella
{
  /// Returns the nodes (s_i, t_j) of the grid of two bases on the unit square,
  /// the first coordinate running fastest.
  std::vector<dealii::Point<2>>
  grid_points(const GaussLobattoBasis &s, const GaussLobattoBasis &t);

  /// Computes the functions L_i(s) L_j(t) of these nodes at @p st into
  /// @p values.
  void
  evaluate_on_grid(const GaussLobattoBasis &s,
                   const GaussLobattoBasis &t,
                   const dealii::Point<2>  &st,
                   std::vector<double>     &values);
} // namespace lamella

#endif
