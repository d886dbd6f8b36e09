// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/strength/criterion.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  double
  FailureSurface::exposure(const Voigt &s, const double angle) const
  {
    const double c = std::cos(angle), z = std::sin(angle);
    const double normal = s[1] * c * c + s[2] * z * z + 2. * s[5] * c * z,
                 across = (s[2] - s[1]) * c * z + s[5] * (c * c - z * z),
                 along  = s[4] * z + s[3] * c;
    const double t = across * across, l = along * along;
    const bool   opens = normal >= 0.;

    // p / R in the direction of the shear stress on the plane.
    const double of_t  = (opens ? p.pt_tension : p.pt_compression) / Ra,
                 of_l  = (opens ? p.pl_tension : p.pl_compression) / Rl;
    const double slope = t + l > 0. ? (of_t * t + of_l * l) / (t + l) : of_t;
    const double of_normal = (opens ? 1. / Rt - slope : slope) * normal;
    return std::sqrt(of_normal * of_normal + t / (Ra * Ra) + l / (Rl * Rl)) +
           slope * normal;
  }



  namespace
  {
    /// Maximum of @p f in [a, b] by golden section: value and place.
    template <typename Function>
    std::pair<double, double>
    largest_between(double a, double b, const Function &f)
    {
      constexpr double golden = 0.6180339887498949;
      double           x = b - golden * (b - a), y = a + golden * (b - a);
      double           at_x = f(x), at_y = f(y);
      while (b - a > 1e-10)
        if (at_x > at_y)
          {
            b    = y;
            y    = x;
            at_y = at_x;
            x    = b - golden * (b - a);
            at_x = f(x);
          }
        else
          {
            a    = x;
            x    = y;
            at_x = at_y;
            y    = a + golden * (b - a);
            at_y = f(y);
          }
      return {at_x, x};
    }



    /// Where @p at, which ends beyond 1, first is 1 between 0 and @p end: steps
    /// in which an exposure that does not rise all along is looked through, and
    /// halvings until doubles have no more digits.
    template <typename Function>
    double
    root_before(const Function &at, const double end)
    {
      constexpr unsigned int n_steps = 64, n_halvings = 60;
      double                 low = 0., high = end;
      for (unsigned int i = 1; i <= n_steps && high == end; ++i)
        if (at(end * i / n_steps) >= 1.)
          high = end * i / n_steps;
        else
          low = end * i / n_steps;
      for (unsigned int i = 0; i < n_halvings; ++i)
        {
          const double middle            = 0.5 * (low + high);
          (at(middle) < 1. ? low : high) = middle;
        }
      return 0.5 * (low + high);
    }
  } // namespace



  std::pair<double, double>
  FailureSurface::action_plane(const Voigt &stress) const
  {
    // All planes stand in half a turn. Maxima are wider than two steps; of
    // those that are near the largest each is refined by the golden section.
    constexpr unsigned int n    = 36;
    constexpr double       step = numbers::PI / n;
    constexpr double       near = 0.9;

    std::array<double, n> f;
    for (unsigned int i = 0; i < n; ++i)
      f[i] = exposure(stress, i * step);
    const double largest = *std::max_element(f.begin(), f.end());
    // The two faces of a plane are one.
    std::pair<double, double> best{-1., 0.};
    for (unsigned int i = 0; i < n; ++i)
      {
        if (f[i] < near * largest || f[i] < f[(i + 1) % n] ||
            f[i] < f[(i + n - 1) % n])
          continue;
        const auto refined = largest_between((i - 1.) * step,
                                             (i + 1.) * step,
                                             [&](const double angle) {
                                               return exposure(stress, angle);
                                             });
        // The grid has planes that rounding must not miss, as that at 0.
        for (const auto &[value, angle] :
             {std::make_pair(f[i], i * step), refined})
          if (value > best.first * (1. + arithmetic::rounding))
            best = {value, angle};
      }
    if (best.second > 0.5 * numbers::PI)
      best.second -= numbers::PI;
    return best;
  }



  Assessment
  FailureSurface::assess_planes(const Voigt &mechanical,
                                const Voigt &residual) const
  {
    constexpr double nothing = 1e-6;
    const auto       at      = [&](const double R) {
      return action_plane(R * mechanical + residual).first;
    };
    const auto [f, angle] = action_plane(mechanical + residual);
    Assessment result{f, {}, "", angle};
    double     R = 1.;
    if (residual.norm() == 0.)
      {
        if (f > nothing)
          result.reserve = 1. / f;
      }
    else if (const double alone = action_plane(mechanical).first; at(0.) >= 1.)
      result.reserve = 0.;
    else if (alone > nothing)
      {
        double end = (1. + action_plane(-residual).first) / alone;
        while (at(end) < 1.)
          end *= 2.;
        result.reserve = root_before(at, end);
      }
    if (result.reserve)
      R = *result.reserve;
    // The plane is that of the stress that fails.
    const Voigt  fails = R * mechanical + residual;
    const double plane =
      residual.norm() == 0. ? angle : action_plane(fails).second;
    const double c = std::cos(plane), z = std::sin(plane);
    const double normal =
      fails[1] * c * c + fails[2] * z * z + 2. * fails[5] * c * z;
    result.mode =
      normal >= 0. ? "inter-fiber tension" : "inter-fiber compression";
    result.angle = plane * 180. / numbers::PI;
    return result;
  }
} // namespace lamella
