// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/strength/criterion.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

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
    const double rotation = (face_angle - core_angle) * numbers::PI / 180.;
    const double c        = std::pow(std::cos(rotation), 2),
                 s        = std::pow(std::sin(rotation), 2);
    const auto hoff       = [&core](const double E, const double G) {
      return 0.5 * std::cbrt(E * core.E3 * G);
    };
    return {hoff(face.E1, core.G13 * c + core.G23 * s),
            hoff(face.E2, core.G13 * s + core.G23 * c)};
  }



  namespace
  {
    // Larger roots of a quadratic form may be rounding (16 digits).
    constexpr double out_of_reach = 1e6;



    /// The linear functions whose signs choose a piece.
    std::array<double, 4>
    switches(const Voigt &s)
    {
      return {{s[0], s[1], s[2], s[1] + s[2]}};
    }



    /// The R from 0 on at which a piece of R @p mechanical + @p residual ends,
    /// ascending; the last ones are out of reach.
    std::array<double, 6>
    sign_changes(const Voigt &mechanical, const Voigt &residual)
    {
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
      return ends;
    }



    /// The smallest root above @p from of a R^2 + b R + c, if any; f(from) < 0.
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



  std::pair<double, std::string_view>
  FailureSurface::largest_form(const Voigt &stress) const
  {
    double           largest = -std::numeric_limits<double>::infinity();
    std::string_view mode;
    for (const Form &form : forms[signs_of(stress)])
      if (const double f = form(stress); f > largest)
        {
          largest = f;
          mode    = form.mode;
        }
    return {largest, mode};
  }



  Assessment
  FailureSurface::assess_forms(const Voigt &mechanical,
                               const Voigt &residual) const
  {
    Assessment  result;
    const Voigt stress                  = mechanical + residual;
    std::tie(result.index, result.mode) = largest_form(stress);

    // From one change of sign to the next.
    const std::array<double, 6> ends = sign_changes(mechanical, residual);
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
} // namespace lamella
