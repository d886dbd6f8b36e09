// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/body/body.h>
#include <lamella/body/line_crossings.h>

#include <deal.II/base/quadrature_lib.h>

#include <boost/math/tools/toms748_solve.hpp>

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



  void
  add_curve_crossings(const std::function<Point<2>(const double)> &x,
                      const Point<2>                              &a,
                      const Tensor<1, 2>                          &d,
                      const double                                 tolerance,
                      std::vector<double>                         &crossings)
  {
    constexpr unsigned int intervals = 4, bits = 50;
    const auto             side_of = [&](const double s) {
      const Point<2> p = x(s);
      return (d[0] * (p[1] - a[1]) - d[1] * (p[0] - a[0])) / d.norm();
    };
    const auto add = [&](const double s) {
      crossings.push_back(((x(s) - a) * d) / d.norm_square());
    };
    for (unsigned int k = 0; k <= intervals; ++k)
      {
        const double s = double(k) / intervals, here = side_of(s);
        if (std::abs(here) <= tolerance)
          add(s);
        if (k == intervals || std::abs(here) <= tolerance)
          continue;
        const double next = side_of((k + 1.) / intervals);
        if (std::abs(next) <= tolerance || here * next > 0.)
          continue;
        std::uintmax_t steps = 100;
        const auto     root  = boost::math::tools::toms748_solve(
          side_of,
          s,
          (k + 1.) / intervals,
          here,
          next,
          boost::math::tools::eps_tolerance<double>(bits),
          steps);
        add(0.5 * (root.first + root.second));
      }
  }



  std::vector<double>
  merge_breaks(std::vector<double> breaks)
  {
    breaks.insert(breaks.end(), {0., 1.});
    std::sort(breaks.begin(), breaks.end());
    std::vector<double> inside;
    for (const double t : breaks)
      if (t >= 0. && t <= 1. &&
          (inside.empty() || t - inside.back() > arithmetic::same_position))
        inside.push_back(t);
    inside.back() = 1.;
    return inside;
  }



  std::vector<Point<3>>
  line_points(const Body &body, const Point<3> &from, const Point<3> &to)
  {
    const QGaussLobatto<1>    nodes(body.line_degree(from, to) + 1);
    const std::vector<double> breaks = body.line_breaks(from, to);
    std::vector<Point<3>>     points;
    for (unsigned int k = 0; k + 1 < breaks.size(); ++k)
      for (unsigned int q = k == 0 ? 0 : 1; q < nodes.size(); ++q)
        points.push_back(
          from + (breaks[k] + nodes.point(q)[0] * (breaks[k + 1] - breaks[k])) *
                   (to - from));
    return points;
  }
} // namespace lamella
