// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/body/cell_grid.h>

#include <array>

namespace lamella
{
  using namespace dealii;

  CellGrid::CellGrid(const GridIntervals &degrees)
    : degrees(degrees)
  {
    std::array<const GaussLobattoBasis *, 3> basis;
    for (unsigned int d = 0; d < 3; ++d)
      basis[d] = &GaussLobattoBasis::of_degree(degrees[d]);
    for (unsigned int k = 0; k <= degrees[2]; ++k)
      for (unsigned int j = 0; j <= degrees[1]; ++j)
        for (unsigned int i = 0; i <= degrees[0]; ++i)
          grid.emplace_back(basis[0]->point(i),
                            basis[1]->point(j),
                            basis[2]->point(k));
  }



  CellGrid::Functions
  CellGrid::evaluate(const Point<3> &unit) const
  {
    using Values = std::array<double, GaussLobattoBasis::max_size>;
    std::array<Values, 3> L, dL;
    for (unsigned int d = 0; d < 3; ++d)
      GaussLobattoBasis::of_degree(degrees[d])
        .evaluate(unit[d], L[d].data(), dL[d].data());
    Functions functions;
    for (unsigned int k = 0; k <= degrees[2]; ++k)
      for (unsigned int j = 0; j <= degrees[1]; ++j)
        for (unsigned int i = 0; i <= degrees[0]; ++i)
          {
            functions.N.push_back(L[0][i] * L[1][j] * L[2][k]);
            functions.dN.push_back(Point<3>(dL[0][i] * L[1][j] * L[2][k],
                                            L[0][i] * dL[1][j] * L[2][k],
                                            L[0][i] * L[1][j] * dL[2][k]));
          }
    return functions;
  }



  std::vector<Point<3>>
  CellGrid::positions(const Body &body, const unsigned int cell) const
  {
    std::vector<Point<3>> x;
    for (const Point<3> &unit : grid)
      x.push_back(body.position({cell, unit}));
    return x;
  }
} // namespace lamella
