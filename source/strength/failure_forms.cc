// SPDX-License-Identifier: LGPL-2.1-or-later

// The quadratic forms of each criterion (doc/theory/strength.md).

#include <lamella/base/arithmetic.h>
#include <lamella/strength/criterion.h>

#include <deal.II/base/exceptions.h>
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



    double
    square(const double x)
    {
      return x * x;
    }



    double
    inverse_square(const double x)
    {
      return 1. / (x * x);
    }



    Voigt
    voigt(const double (&values)[6])
    {
      Voigt result;
      for (unsigned int i = 0; i < 6; ++i)
        result[i] = values[i];
      return result;
    }



    Voigt
    unit(const unsigned int i, const double value)
    {
      Voigt result;
      result[i] = value;
      return result;
    }



    constexpr std::array<const char *, 3> tension = {
      {"tension 1", "tension 2", "tension 3"}};
    constexpr std::array<const char *, 3> compression = {
      {"compression 1", "compression 2", "compression 3"}};
    constexpr std::array<const char *, 3> shear = {
      {"shear 12", "shear 13", "shear 23"}};



    /// epsilon_i = rows_i . sigma.
    std::array<Voigt, 6>
    compliance_rows(const EngineeringConstants &m)
    {
      const double n12 = -m.nu12 / m.E1, n13 = -m.nu13 / m.E1,
                   n23 = -m.nu23 / m.E2;
      return {{voigt({1. / m.E1, n12, n13, 0., 0., 0.}),
               voigt({n12, 1. / m.E2, n23, 0., 0., 0.}),
               voigt({n13, n23, 1. / m.E3, 0., 0., 0.}),
               unit(3, 1. / m.G12),
               unit(4, 1. / m.G13),
               unit(5, 1. / m.G23)}};
    }



    /// The largest c_i . sigma / limit of the limits @p s; @p row gives c_i.
    template <typename F, typename LinearFunctional>
    std::vector<F>
    maximum_forms(const Strengths &s, const LinearFunctional &row)
    {
      const std::array<double, 3> t = {{s.Xt, s.Yt, s.Zt}},
                                  c = {{s.Xc, s.Yc, s.Zc}},
                                  q = {{s.S12, s.S13, s.S23}};
      std::vector<F> forms;
      for (unsigned int i = 0; i < 3; ++i)
        {
          forms.push_back({tension[i], {}, row(i) / t[i]});
          forms.push_back({compression[i], {}, -row(i) / c[i]});
          forms.push_back({shear[i], {}, row(3 + i) / q[i]});
          forms.push_back({shear[i], {}, -row(3 + i) / q[i]});
        }
      return forms;
    }



    template <typename F>
    std::vector<F>
    maximum_strain_forms(const Material &material)
    {
      const auto compliance = compliance_rows(material.elastic);
      return maximum_forms<F>(*material.ultimate_strains,
                              [&](const unsigned int i) {
                                return compliance[i];
                              });
    }



    template <typename F>
    F
    tsai_hill_form(const Strengths &s, const unsigned int signs)
    {
      const double x = inverse_square(signs & 1 ? s.Xc : s.Xt),
                   y = inverse_square(signs & 2 ? s.Yc : s.Yt),
                   z = inverse_square(signs & 4 ? s.Zc : s.Zt);
      return {"quadratic",
              voigt({x,
                     y,
                     z,
                     inverse_square(s.S12),
                     inverse_square(s.S13),
                     inverse_square(s.S23)}),
              {},
              {{-(x + y - z), -(x + z - y), -(y + z - x)}}};
    }



    /// Tsai-Wu and Hoffman, which differ in the products.
    template <typename F>
    F
    tensor_form(const Strengths &s, const bool is_hoffman)
    {
      const double x = 1. / (s.Xt * s.Xc), y = 1. / (s.Yt * s.Yc),
                   z = 1. / (s.Zt * s.Zc);
      F form{"quadratic",
             voigt({x,
                    y,
                    z,
                    inverse_square(s.S12),
                    inverse_square(s.S13),
                    inverse_square(s.S23)}),
             voigt({1. / s.Xt - 1. / s.Xc,
                    1. / s.Yt - 1. / s.Yc,
                    1. / s.Zt - 1. / s.Zc,
                    0.,
                    0.,
                    0.})};
      if (is_hoffman)
        form.products = {{-(x + y - z), -(x + z - y), -(y + z - x)}};
      else
        form.products = {
          {-std::sqrt(x * y), -std::sqrt(x * z), -std::sqrt(y * z)}};
      return form;
    }



    template <typename F>
    std::vector<F>
    hashin_forms(const Strengths &s, const unsigned int signs)
    {
      const double   l = inverse_square(s.S12), t = inverse_square(s.S23);
      std::vector<F> forms;
      if (signs & 1)
        forms.push_back({"fiber compression", {}, unit(0, -1. / s.Xc)});
      else
        forms.push_back(
          {"fiber tension", voigt({inverse_square(s.Xt), 0., 0., l, l, 0.})});
      const bool   closed = signs & 8;
      const double n =
        closed ? inverse_square(2. * s.S23) : inverse_square(s.Yt);
      const double first =
        closed ? (square(s.Yc / (2. * s.S23)) - 1.) / s.Yc : 0.;
      forms.push_back({closed ? "matrix compression" : "matrix tension",
                       voigt({0., n, n, l, l, t}),
                       voigt({0., first, first, 0., 0., 0.}),
                       {{0., 0., 2. * n - t}}});
      return forms;
    }



    /// Puck's fiber fracture.
    template <typename F>
    std::vector<F>
    fiber_forms(const Strengths &s)
    {
      return {{"fiber tension", {}, unit(0, 1. / s.Xt)},
              {"fiber compression", {}, unit(0, -1. / s.Xc)}};
    }



    template <typename F>
    F
    yield_form(const double yield)
    {
      const double y = inverse_square(yield);
      return {"yield", y * voigt({1., 1., 1., 3., 3., 3.}), {}, {{-y, -y, -y}}};
    }



    template <typename F>
    F
    delamination_form(const Strengths &s, const unsigned int signs)
    {
      return {"delamination",
              voigt({0.,
                     0.,
                     signs & 4 ? 0. : inverse_square(s.Zt),
                     0.,
                     inverse_square(s.S13),
                     inverse_square(s.S23)})};
    }



    template <typename F>
    std::vector<F>
    core_shear_forms(const CoreStrengths &core)
    {
      return {{"core shear 13", {}, unit(4, 1. / core.shear_13)},
              {"core shear 13", {}, unit(4, -1. / core.shear_13)},
              {"core shear 23", {}, unit(5, 1. / core.shear_23)},
              {"core shear 23", {}, unit(5, -1. / core.shear_23)}};
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



  std::vector<FailureSurface::Form>
  FailureSurface::forms_of(const Criterion          criterion,
                           const Material          &material,
                           const WrinklingStresses &wrinkling,
                           const Signs              signs) const
  {
    const Strengths s = material.strengths.value_or(Strengths());
    switch (criterion)
      {
        case Criterion::maximum_stress:
          return maximum_forms<Form>(s, [](const unsigned int i) {
            return unit(i, 1.);
          });
        case Criterion::maximum_strain:
          return maximum_strain_forms<Form>(material);
        case Criterion::tsai_hill:
          return {tsai_hill_form<Form>(s, signs)};
        case Criterion::tsai_wu:
        case Criterion::hoffman:
          return {tensor_form<Form>(s, criterion == Criterion::hoffman)};
        case Criterion::hashin:
          return hashin_forms<Form>(s, signs);
        case Criterion::puck:
          return fiber_forms<Form>(s);
        case Criterion::von_mises:
          return {yield_form<Form>(*material.yield)};
        case Criterion::interlaminar:
          return {delamination_form<Form>(s, signs)};
        case Criterion::core_shear:
          return core_shear_forms<Form>(*material.core);
        case Criterion::core_crushing:
          return {
            {"core crushing", {}, unit(2, -1. / material.core->crushing)}};
        case Criterion::face_wrinkling:
          return {{"wrinkling 1", {}, unit(0, -1. / wrinkling.along_1)},
                  {"wrinkling 2", {}, unit(1, -1. / wrinkling.along_2)}};
        default:
          Assert(false, ExcInternalError());
          return {};
      }
  }
} // namespace lamella
