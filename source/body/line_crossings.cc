// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/body/line_crossings.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  void
  add_edge_crossings(const Point<2>      &p,
                     const Point<2>      &q,
                     const Point<2>      &a,
                     const Tensor<1, 2>  &d,
                     const double         tolerance,
                     std::vector<double> &crossings)
  {
    const auto side_of = [&a, &d](const Point<2> &x) {
      return (d[0] * (x[1] - a[1]) - d[1] * (x[0] - a[0])) / d.norm();
    };
    const auto add = [&](const Point<2> &x) {
      crossings.push_back(((x - a) * d) / d.norm_square());
    };
    const double of_p = side_of(p), of_q = side_of(q);
    if (std::abs(of_p) <= tolerance)
      add(p);
    if (std::abs(of_q) <= tolerance)
      add(q);
    if (of_p * of_q < 0. && std::abs(of_p) > tolerance &&
        std::abs(of_q) > tolerance)
      add(p + of_p / (of_p - of_q) * (q - p));
  }



  std::vector<double>
  tidy_breaks(std::vector<double> breaks)
  {
    breaks.insert(breaks.end(), {0., 1.});
    std::sort(breaks.begin(), breaks.end());
    std::vector<double> inside;
    for (const double t : breaks)
      if (t >= 0. && t <= 1. && (inside.empty() || t - inside.back() > 1e-9))
        inside.push_back(t);
    inside.back() = 1.;
    return inside;
  }
} // namespace lamella
