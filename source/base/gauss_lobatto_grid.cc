// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/gauss_lobatto_grid.h>

#include <array>

namespace lamella
{
  using namespace dealii;

  std::vector<Point<2>>
  grid_points(const GaussLobattoBasis &s, const GaussLobattoBasis &t)
  {
    std::vector<Point<2>> points;
    for (unsigned int j = 0; j < t.size(); ++j)
      for (unsigned int i = 0; i < s.size(); ++i)
        points.emplace_back(s.point(i), t.point(j));
    return points;
  }



  void
  evaluate_on_grid(const GaussLobattoBasis &s,
                   const GaussLobattoBasis &t,
                   const Point<2>          &st,
                   std::vector<double>     &values)
  {
    std::array<double, GaussLobattoBasis::max_size> of_s, of_t;
    s.evaluate(st[0], of_s.data(), nullptr);
    t.evaluate(st[1], of_t.data(), nullptr);
    values.clear();
    for (unsigned int j = 0; j < t.size(); ++j)
      for (unsigned int i = 0; i < s.size(); ++i)
        values.push_back(of_s[i] * of_t[j]);
  }
} // namespace lamella
