// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/strength/criterion.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamella
{
  using namespace dealii;

  std::vector<std::string>
  criterion_names()
  {
    std::vector<std::string> names;
    for (const auto &criterion : Names<Criterion>::all)
      names.emplace_back(criterion.name);
    return names;
  }



  std::string
  missing_entry(const Criterion criterion, const Material &material)
  {
    switch (criterion)
      {
        case Criterion::maximum_strain:
          return material.ultimate_strains ? "" : "Ultimate strains";
        case Criterion::von_mises:
          return material.yield ? "" : "Yield";
        case Criterion::core_shear:
        case Criterion::core_crushing:
          return material.core ? "" : "Core strengths";
        case Criterion::face_wrinkling:
          return "";
        default:
          return material.strengths ? "" : "Strengths";
      }
  }



  WrinklingStresses
  wrinkling_stresses(const EngineeringConstants &face,
                     const EngineeringConstants &core,
                     const double                face_angle,
                     const double                core_angle)
  {
    const double turn = (face_angle - core_angle) * numbers::PI / 180.;
    const double c    = std::pow(std::cos(turn), 2),
                 s    = std::pow(std::sin(turn), 2);
    const auto hoff   = [&core](const double E, const double G) {
      return 0.5 * std::cbrt(E * core.E3 * G);
    };
    return {hoff(face.E1, core.G13 * c + core.G23 * s),
            hoff(face.E2, core.G13 * s + core.G23 * c)};
  }



  namespace
  {
    // Beyond this a surface is out of reach: with 16 digits of a quadratic form
    // such a root may be rounding.
    constexpr double out_of_reach = 1e6;



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



    /// The linear functions whose signs choose a piece.
    std::array<double, 4>
    switches(const Voigt &s)
    {
      return {{s[0], s[1], s[2], s[1] + s[2]}};
    }



    /// The smallest root above @p from of a R^2 + b R + c, which is negative at
    /// @p from; none if there is none.
    std::optional<double>
    next_root(const double a, const double b, const double c, const double from)
    {
      const double discriminant = b * b - 4. * a * c;
      if (discriminant < 0.)
        return {};
      // Without cancellation: one root is t / a, the other c / t.
      const double t = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
      std::optional<double> least;
      const auto            offer = [&](const double root) {
        if (std::isfinite(root) && root > from && (!least || root < *least))
          least = root;
      };
      offer(t / a);
      offer(c / t);
      return least;
    }
  } // namespace



  double
  FailureSurface::Form::bilinear(const Voigt &s, const Voigt &t) const
  {
    double sum = 0.;
    for (unsigned int i = 0; i < 6; ++i)
      sum += squares[i] * s[i] * t[i];
    return sum + 0.5 * (products[0] * (s[0] * t[1] + s[1] * t[0]) +
                        products[1] * (s[0] * t[2] + s[2] * t[0]) +
                        products[2] * (s[1] * t[2] + s[2] * t[1]));
  }



  FailureSurface::Signs
  FailureSurface::signs_of(const Voigt &stress)
  {
    Signs signs = 0, bit = 1;
    for (const double value : switches(stress))
      {
        signs += value < 0. ? bit : 0;
        bit *= 2;
      }
    return signs;
  }



  FailureSurface::FailureSurface(const Criterion          criterion,
                                 const Material          &material,
                                 const WrinklingStresses &wrinkling)
  {
    Assert(missing_entry(criterion, material).empty(), ExcInternalError());
    for (Signs signs = 0; signs < n_signs; ++signs)
      forms[signs] = forms_of(criterion, material, wrinkling, signs);
    if (criterion == Criterion::puck)
      {
        has_planes = true;
        p          = material.inclinations;
        Rt         = material.strengths->Yt;
        Rl         = material.strengths->S12;
        Ra         = material.strengths->Yc / (2. * (1. + p.pt_compression));
      }
  }



  // ---- the forms of each criterion

  namespace
  {
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



    /// The largest of c_i . sigma / limit over the nine limits @p s, where
    /// @p row gives the c_i.
    template <typename F, typename Row>
    std::vector<F>
    maximum_forms(const Strengths &s, const Row &row)
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
        forms.push_back({"fibre compression", {}, unit(0, -1. / s.Xc)});
      else
        forms.push_back(
          {"fibre tension", voigt({inverse_square(s.Xt), 0., 0., l, l, 0.})});
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
  } // namespace



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
          {
            const auto compliance = compliance_rows(material.elastic);
            return maximum_forms<Form>(*material.ultimate_strains,
                                       [&](const unsigned int i) {
                                         return compliance[i];
                                       });
          }
        case Criterion::tsai_hill:
          return {tsai_hill_form<Form>(s, signs)};
        case Criterion::tsai_wu:
        case Criterion::hoffman:
          return {tensor_form<Form>(s, criterion == Criterion::hoffman)};
        case Criterion::hashin:
          return hashin_forms<Form>(s, signs);
        case Criterion::puck:
          return {{"fibre tension", {}, unit(0, 1. / s.Xt)},
                  {"fibre compression", {}, unit(0, -1. / s.Xc)}};
        case Criterion::von_mises:
          {
            const double y = inverse_square(*material.yield);
            return {{"yield",
                     y * voigt({1., 1., 1., 3., 3., 3.}),
                     {},
                     {{-y, -y, -y}}}};
          }
        case Criterion::interlaminar:
          return {{"delamination",
                   voigt({0.,
                          0.,
                          signs & 4 ? 0. : inverse_square(s.Zt),
                          0.,
                          inverse_square(s.S13),
                          inverse_square(s.S23)})}};
        case Criterion::core_shear:
          return {{"core shear 13", {}, unit(4, 1. / material.core->shear_13)},
                  {"core shear 13", {}, unit(4, -1. / material.core->shear_13)},
                  {"core shear 23", {}, unit(5, 1. / material.core->shear_23)},
                  {"core shear 23",
                   {},
                   unit(5, -1. / material.core->shear_23)}};
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



  // ---- assessment

  std::optional<std::pair<double, const FailureSurface::Form *>>
  FailureSurface::first_root(const Signs  signs,
                             const Voigt &mechanical,
                             const Voigt &residual,
                             const double from,
                             const double to) const
  {
    std::optional<std::pair<double, const Form *>> least;
    for (const Form &form : forms[signs])
      {
        const double a = form.bilinear(mechanical, mechanical),
                     b = 2. * form.bilinear(mechanical, residual) +
                         form.linear * mechanical,
                     c = form(residual) - 1.;
        const std::optional<double> root =
          (a * from + b) * from + c >= 0. ? from : next_root(a, b, c, from);
        if (root && *root <= to && (!least || *root < least->first))
          least = {*root, &form};
      }
    return least;
  }



  Assessment
  FailureSurface::assess_forms(const Voigt &mechanical,
                               const Voigt &residual) const
  {
    Assessment  result;
    const Voigt stress = mechanical + residual;
    result.index       = -std::numeric_limits<double>::infinity();
    for (const Form &form : forms[signs_of(stress)])
      if (const double f = form(stress); f > result.index)
        {
          result.index = f;
          result.mode  = form.mode;
        }

    // From one change of sign to the next.
    std::array<double, 6> ends{{0.,
                                out_of_reach,
                                out_of_reach,
                                out_of_reach,
                                out_of_reach,
                                out_of_reach}};
    const auto            m = switches(mechanical), r = switches(residual);
    for (unsigned int i = 0; i < 4; ++i)
      if (const double end = -r[i] / m[i]; end > 0. && end < out_of_reach)
        ends[i + 1] = end;
    std::sort(ends.begin(), ends.end());
    for (unsigned int i = 0; i < 5 && ends[i] < out_of_reach; ++i)
      {
        const double inside = ends[i + 1] < out_of_reach ?
                                0.5 * (ends[i] + ends[i + 1]) :
                                2. * ends[i] + 1.;
        const auto   root = first_root(signs_of(inside * mechanical + residual),
                                     mechanical,
                                     residual,
                                     ends[i],
                                     ends[i + 1]);
        if (!root || root->first >= out_of_reach)
          continue;
        result.reserve = root->first;
        result.mode    = root->second->mode;
        break;
      }
    return result;
  }



  Assessment
  FailureSurface::assess(const Voigt &mechanical, const Voigt &residual) const
  {
    Assessment result = assess_forms(mechanical, residual);
    if (!has_planes)
      return result;
    const Assessment planes = assess_planes(mechanical, residual);
    const bool       first =
      planes.reserve && (!result.reserve || *planes.reserve < *result.reserve);
    const bool larger =
      !planes.reserve && !result.reserve && planes.index > result.index;
    const double index = std::max(result.index, planes.index);
    if (first || larger)
      result = planes;
    result.index = index;
    return result;
  }



  double
  FailureSurface::index(const Voigt &stress) const
  {
    double largest = -std::numeric_limits<double>::infinity();
    for (const Form &form : forms[signs_of(stress)])
      largest = std::max(largest, form(stress));
    return has_planes ? std::max(largest, action_plane(stress).first) : largest;
  }
} // namespace lamella
