// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/material/parameters.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace lamella
{
  namespace
  {
    using Named = std::pair<const char *, double>;

    /// Returns the request to check @p what ("numbers are") against @p units.
    std::string
    remedy(const std::string &what, const Units &units)
    {
      if (units.stress.empty())
        return ". Check that all values have the same unit";
      return ". Units = " + units.length + ", " + units.force +
             " means stresses in " + units.stress + "; check that " + what +
             " in this unit";
    }



    /// Quotient of two named numbers.
    struct Ratio
    {
      Named over, under;

      double
      value() const
      {
        return over.second / under.second;
      }
    };



    /// Returns the ratio of each strength to the modulus of its direction.
    std::vector<Ratio>
    strength_ratios(const Material &material)
    {
      const EngineeringConstants &c = material.elastic;
      const Named E1("E1", c.E1), E2("E2", c.E2), E3("E3", c.E3),
        G12("G12", c.G12), G13("G13", c.G13), G23("G23", c.G23);
      std::vector<Ratio> all;
      if (const auto &s = material.strengths)
        all = {{{"Xt", s->Xt}, E1},
               {{"Xc", s->Xc}, E1},
               {{"Yt", s->Yt}, E2},
               {{"Yc", s->Yc}, E2},
               {{"Zt", s->Zt}, E3},
               {{"Zc", s->Zc}, E3},
               {{"S12", s->S12}, G12},
               {{"S13", s->S13}, G13},
               {{"S23", s->S23}, G23}};
      if (material.yield)
        all.push_back({{"Yield", *material.yield}, E1});
      if (const auto &core = material.core)
        all.insert(all.end(),
                   {{{"crushing", core->crushing}, E3},
                    {{"shear 13", core->shear_13}, G13},
                    {{"shear 23", core->shear_23}, G23}});
      return all;
    }



    std::vector<Ratio>
    shear_ratios(const EngineeringConstants &c)
    {
      const Named        E1("E1", c.E1), E2("E2", c.E2), G12("G12", c.G12);
      std::vector<Ratio> all{{G12, E1}, {G12, E2}};
      // Honeycombs have any G13 / E1, and very small E3.
      if (c.E3 <= c.E1)
        all.insert(all.end(), {{{"G13", c.G13}, E1}, {{"G23", c.G23}, E2}});
      return all;
    }



    /// Returns a sentence on the ratio of @p ratios that is farthest outside of
    /// @p low to @p high; empty if all are inside.
    std::string
    worst_ratio(const std::vector<Ratio> &ratios,
                const double              low,
                const double              high,
                const Units              &units)
    {
      const Ratio *worst   = nullptr;
      double       outside = 1.;
      for (const Ratio &one : ratios)
        if (const double off = std::max(low / one.value(), one.value() / high);
            off > outside)
          {
            worst   = &one;
            outside = off;
          }
      if (worst == nullptr)
        return "";
      const auto number = [&units](const Named &named) {
        return std::string(named.first) + " = " + to_text(named.second) +
               (units.stress.empty() ? "" : " ") + units.stress;
      };
      return number(worst->over) + " is " + to_text(worst->value(), 2) +
             " times " + number(worst->under) +
             ", and of solids this ratio lies between " + to_text(low) +
             " and " + to_text(high) +
             remedy(std::string(worst->over.first) + " and " +
                      worst->under.first + " are",
                    units);
    }



    std::string
    ultimate_strain_warning(const Strengths &strains, const double most)
    {
      const auto &[Xt, Xc, Yt, Yc, Zt, Zc, S12, S13, S23] = strains;
      const double largest = std::max({Xt, Xc, Yt, Yc, Zt, Zc, S12, S13, S23});
      if (largest <= most)
        return "";
      return "Ultimate strains reach " + to_text(largest) +
             ", and solids break below " + to_text(most) +
             ". They are numbers: 1.5 % is 0.015";
    }



    std::string
    density_warning(const double density, const Units &units)
    {
      // Lower limit: aerogels; upper limit: osmium [kg/m^3].
      constexpr double lightest = 5., heaviest = 25000.;
      // A stress is a force over length^2, a density one over length^4.
      const double of_scene = units.pascal * units.pascal;
      if (units.stress.empty() || density == 0. ||
          (density >= lightest * of_scene && density <= heaviest * of_scene))
        return "";
      const std::string unit = units.length == "m" ? "kg/m^3" : "t/mm^3";
      return "Density = " + to_text(density) + " " + unit +
             ", and solids have " + to_text(lightest * of_scene) + " to " +
             to_text(heaviest * of_scene) + " " + unit +
             ". Units = " + units.length + ", " + units.force +
             " has densities in " + unit + ": steel has " +
             to_text(7850. * of_scene);
    }



    std::string
    expansion_warning(const dealii::Tensor<1, 3> &alpha)
    {
      constexpr double most = 1e-3;
      const double     largest =
        std::max({std::abs(alpha[0]), std::abs(alpha[1]), std::abs(alpha[2])});
      if (largest <= most)
        return "";
      return "Thermal expansion reaches " + to_text(largest) +
             " per kelvin, and solids have less than " + to_text(most) +
             ". Steel has 12e-6";
    }
  } // namespace



  std::pair<const char *, double>
  largest_modulus(const Material &material)
  {
    const EngineeringConstants &c = material.elastic;
    return std::max({Named("E1", c.E1), Named("E2", c.E2), Named("E3", c.E3)},
                    [](const Named &a, const Named &b) {
                      return a.second < b.second;
                    });
  }



  std::string
  moduli_warning(const std::string &name,
                 const Material    &material,
                 const Units       &units)
  {
    // Of soft foams and of diamond, in pascals.
    constexpr double softest = 1e6, stiffest = 2e12;
    if (units.stress.empty())
      return "";
    const EngineeringConstants &c = material.elastic;
    // Cores may be softer in their plane.
    const bool is_soft =
      largest_modulus(material).second < softest * units.pascal;
    std::vector<std::string> odd;
    for (const auto &[what, modulus] : {Named("E1", c.E1),
                                        Named("E2", c.E2),
                                        Named("E3", c.E3),
                                        Named("G12", c.G12),
                                        Named("G13", c.G13),
                                        Named("G23", c.G23)})
      if ((is_soft && modulus < softest * units.pascal) ||
          modulus > stiffest * units.pascal)
        odd.push_back(std::string(what) + " = " + to_text(modulus) + " " +
                      units.stress);
    if (odd.empty())
      return "";
    return "material.modulus-out-of-range: material " + name +
           ": moduli of solids lie between 1 MPa and 2 TPa, but here " +
           joined(odd) + remedy("the moduli are", units);
  }



  std::vector<std::string>
  material_warnings(const std::string &name,
                    const Material    &material,
                    const Units       &units)
  {
    // Limits for strengths: concrete in tension, whiskers. Limits for shear
    // moduli: stiffest fibers with resin, laminates at 45 degrees. Numbers in
    // another unit are off by a factor of a thousand.
    constexpr double weakest = 1. / 10000., strongest = 0.3, least_shear = 1e-3,
                     most_shear = 10.;
    std::vector<std::string> plausibility_warnings;
    const auto add = [&](const std::string &id, const std::string &warning) {
      if (!warning.empty())
        plausibility_warnings.push_back("material." + id + ": material " +
                                        name + ": " + warning);
    };
    if (const std::string warning = moduli_warning(name, material, units);
        !warning.empty())
      plausibility_warnings.push_back(warning);
    std::string ratio = worst_ratio(shear_ratios(material.elastic),
                                    least_shear,
                                    most_shear,
                                    units);
    // A wrong shear modulus makes its strength look wrong, too.
    if (ratio.empty())
      ratio = worst_ratio(strength_ratios(material), weakest, strongest, units);
    add("ratio-out-of-range", ratio);
    if (material.ultimate_strains)
      add("ultimate-strain-too-large",
          ultimate_strain_warning(*material.ultimate_strains, strongest));
    if (material.density)
      add("density-out-of-range", density_warning(*material.density, units));
    if (material.expansion)
      add("expansion-too-large", expansion_warning(*material.expansion));
    return plausibility_warnings;
  }
} // namespace lamella
