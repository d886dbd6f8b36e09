// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/shape/ellipse_projection.h>

#include <deal.II/base/numbers.h>

#include <boost/math/tools/roots.hpp>

#include <cmath>
#include <limits>
#include <utility>

namespace lamella
{
  using namespace dealii;

  double
  EllipseProjection::parameter(const Point<2> &x) const
  {
    const Tensor<1, 2> d = x - center;
    if (a == b)
      return std::atan2(d[1], d[0]);
    // In the first quadrant, and back.
    const double p = std::abs(d[0]), q = std::abs(d[1]);
    const auto   f = [&](const double phi) {
      const double c = std::cos(phi), s = std::sin(phi);
      return std::make_pair((a * a - b * b) * s * c - a * p * s + b * q * c,
                            (a * a - b * b) * (c * c - s * s) - a * p * c -
                              b * q * s);
    };
    constexpr double quarter = 0.5 * numbers::PI;
    double           phi     = q == 0. ? 0. : quarter;
    if (p != 0. && q != 0.)
      phi = boost::math::tools::newton_raphson_iterate(
        f,
        std::atan2(a * q, b * p),
        0.,
        quarter,
        std::numeric_limits<double>::digits - 2);
    return std::copysign(d[0] < 0. ? numbers::PI - phi : phi, d[1]);
  }



  Point<2>
  EllipseProjection::point(const double phi) const
  {
    return {center[0] + a * std::cos(phi), center[1] + b * std::sin(phi)};
  }



  Tensor<1, 2>
  EllipseProjection::normal(const double phi) const
  {
    const Point<2> n(b * std::cos(phi), a * std::sin(phi));
    return n / n.norm();
  }
} // namespace lamella
