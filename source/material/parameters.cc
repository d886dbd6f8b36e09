// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/patterns.h>
#include <lamella/material/material.h>
#include <lamella/material/parameters.h>

#include <cmath>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  namespace
  {
    void
    declare_strengths(ParameterHandler &prm)
    {
      prm.declare_entry(
        "Strengths",
        "",
        patterns::numbers(),
        "Xt, Xc, Yt, Yc, Zt, Zc, S12, S13, S23: strengths in tension and "
        "compression along the material axes 1, 2, 3, and in shear, in "
        "stresses of the scene. All are positive, also those in compression. "
        "They replace strengths of Library.");
      prm.declare_entry("Ultimate strains",
                        "",
                        patterns::numbers(),
                        "The same nine values as strains, for the criterion "
                        "`maximum strain`; shear in engineering strains.");
      prm.declare_entry("Yield",
                        "",
                        patterns::optional(patterns::positive()),
                        "Yield stress (isotropic material), for `von Mises`.");
      prm.declare_entry("Core strengths",
                        "",
                        patterns::numbers(),
                        "Three strengths of the core of a sandwich: crushing, "
                        "shear 13, shear 23. Core criteria apply to materials "
                        "with these strengths only.");
      prm.declare_entry("Puck inclinations",
                        "carbon",
                        Anything(),
                        "Inclination parameters of Puck's criterion: published "
                        "values for carbon or glass, or four numbers, for "
                        "shear along the fiber with tension and with "
                        "compression, and likewise across the fiber.");
    }



    Material
    parse_library(const Entry &entry, const Units &units)
    {
      const Material material = library_material(entry, units);
      if (units.stress.empty() && entry.text() != "hertz-200")
        entry.refuse("material.library-without-units: built-in materials have "
                     "units, but the scene has Units = none",
                     "Write Units = m, N or Units = mm, N.");
      return material;
    }



    EngineeringConstants
    parse_isotropic(const Entry &entry)
    {
      const std::vector<double> numbers = entry.numbers();
      if (numbers.size() != 2)
        entry.refuse("material.wrong-count: write E, nu, as in 2e11, 0.3");
      if (!(numbers[1] > -1. && numbers[1] < 0.5))
        entry.refuse(
          "material.not-positive-definite: nu must lie between -1 and 0.5");
      return EngineeringConstants::isotropic(numbers[0], numbers[1]);
    }



    EngineeringConstants
    parse_orthotropic(const Entry &entry)
    {
      const std::vector<double> n = entry.numbers();
      if (n.size() != 9)
        entry.refuse("material.wrong-count: write nine numbers, E1, E2, E3, "
                     "G12, G13, G23, nu12, nu13, nu23; the number here is " +
                     std::to_string(n.size()));
      return {n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8]};
    }



    /// As many numbers above zero as @p names says; none if it is empty.
    std::vector<double>
    parse_positive(const Entry &entry, const std::vector<std::string> &names)
    {
      std::vector<double> numbers = entry.numbers();
      if (numbers.empty())
        return numbers;
      if (numbers.size() != names.size())
        entry.refuse("material.wrong-count: must be " +
                     std::to_string(names.size()) + " numbers, " +
                     joined(names) + "; there are " +
                     std::to_string(numbers.size()));
      for (unsigned int i = 0; i < numbers.size(); ++i)
        if (!(numbers[i] > 0.))
          entry.refuse("material.strength-not-positive: " + names[i] + " = " +
                         to_text(numbers[i]) + " must be positive",
                       "Write positive strengths, also in compression.");
      return numbers;
    }



    std::optional<Strengths>
    parse_nine(const Entry &entry)
    {
      const std::vector<double> n = parse_positive(
        entry, {"Xt", "Xc", "Yt", "Yc", "Zt", "Zc", "S12", "S13", "S23"});
      if (n.empty())
        return {};
      return Strengths{n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8]};
    }



    /// alpha_1, alpha_2, alpha_3 of three numbers, or of one for all.
    std::optional<dealii::Tensor<1, 3>>
    parse_expansion(const Entry &entry)
    {
      const std::vector<double> n = entry.numbers();
      if (n.empty())
        return {};
      if (n.size() != 1 && n.size() != 3)
        entry.refuse("material.wrong-count: write one number, or three for the "
                     "material axes 1, 2 and 3; the number here is " +
                     std::to_string(n.size()));
      // A strain of a tenth a kelvin is none of a solid.
      constexpr double     most = 0.1;
      dealii::Tensor<1, 3> alpha;
      for (unsigned int k = 0; k < 3; ++k)
        {
          alpha[k] = n[n.size() == 1 ? 0 : k];
          if (!(std::abs(alpha[k]) < most))
            entry.refuse("material.expansion-too-large: the unit is 1/K, and " +
                           to_text(alpha[k]) + " is too large for a solid",
                         "Write, for example, 12e-6 for steel.");
        }
      return alpha;
    }



    bool
    is_isotropic(const EngineeringConstants &c)
    {
      const auto same = [](const double a, const double b) {
        return std::abs(a - b) <= arithmetic::decimal_tolerance * std::abs(b);
      };
      const double G = 0.5 * c.E1 / (1. + c.nu12);
      return same(c.E2, c.E1) && same(c.E3, c.E1) && same(c.nu13, c.nu12) &&
             same(c.nu23, c.nu12) && same(c.G12, G) && same(c.G13, G) &&
             same(c.G23, G);
    }



    PuckInclinations
    parse_inclinations(const Entry &entry)
    {
      if (entry.text() == "carbon")
        return {};
      if (entry.text() == "glass")
        return PuckInclinations::glass();
      if (entry.items().size() != 4)
        entry.refuse("material.invalid-inclinations: write carbon, glass, or "
                     "four numbers, the inclinations of Puck's criterion");
      const std::vector<double> n = entry.numbers();
      for (const double p : n)
        if (!(p >= 0. && p < 1.))
          entry.refuse("material.inclination-out-of-range: each inclination "
                       "must be at least 0 and less than 1",
                       "Usual values of these slopes are 0.2 to 0.35.");
      return {n[0], n[1], n[2], n[3]};
    }



    /// Puts what the entries say of @p material's strengths into it.
    void
    parse_strengths(const Entries &in, Material &material)
    {
      if (const auto strengths = parse_nine(in["Strengths"]))
        material.strengths = strengths;
      if (const auto strains = parse_nine(in["Ultimate strains"]))
        material.ultimate_strains = strains;
      if (const Entry yield = in["Yield"]; !yield.is_empty())
        {
          material.yield = yield.positive();
          if (!is_isotropic(material.elastic))
            yield.refuse("material.yield-not-isotropic: Yield is for isotropic "
                         "materials only, but this material is orthotropic",
                         "Write Strengths instead of Yield.");
        }
      const std::vector<double> core =
        parse_positive(in["Core strengths"],
                       {"crushing", "shear 13", "shear 23"});
      if (!core.empty())
        material.core = CoreStrengths{core[0], core[1], core[2]};
      material.inclinations = parse_inclinations(in["Puck inclinations"]);
    }



    Material
    parse_elasticity(const Entries &in, const Units &units)
    {
      const Entry library = in["Library"], isotropic = in["Isotropic"],
                  orthotropic = in["Engineering constants"];
      const int given =
        !library.is_empty() + !orthotropic.is_empty() + !isotropic.is_empty();
      if (given != 1)
        in.refuse(

          "material.not-one-source: a material needs exactly one of Library, "
          "Engineering constants and Isotropic, but " +
          std::to_string(given) + " of these entries are given");
      if (!library.is_empty())
        return parse_library(library, units);

      const EngineeringConstants elastic  = isotropic.is_empty() ?
                                              parse_orthotropic(orthotropic) :
                                              parse_isotropic(isotropic);
      const std::string          violated = elastic.violated_condition();
      if (!violated.empty())
        (isotropic.is_empty() ? orthotropic : isotropic)
          .refuse("material.not-positive-definite: the material is not "
                  "positive definite: " +
                  violated);
      return elastic;
    }
  } // namespace



  void
  MaterialParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry("Library",
                      "",
                      Anything(),
                      "A built-in material: " + joined(library_materials()) +
                        ". Converted to the stresses of Units.");
    prm.declare_entry(
      "Engineering constants",
      "",
      patterns::numbers(),
      "Orthotropic material: E1, E2, E3, G12, G13, G23, nu12, nu13, nu23, in "
      "stresses of the scene; 1 is along the fiber, 3 normal to the ply.");
    prm.declare_entry(
      "Isotropic",
      "",
      patterns::numbers(),
      "Isotropic material: E, nu, with E in stresses of the scene.");
    prm.declare_entry(
      "Density",
      "",
      patterns::optional(patterns::number()),
      "Density, for Gravity: kg/m^3 in m, N, and t/mm^3 in mm, N. Other units: "
      "the mass that force and length of the scene make with seconds.");
    prm.declare_entry(
      "Thermal expansion",
      "",
      patterns::numbers(),
      "Thermal expansion, strain per kelvin, for the Temperature of a load: "
      "one number, or three for the axes 1, 2 and 3; may be negative.");
    declare_strengths(prm);
  }



  Material
  MaterialParameters::parse(const Entries &in, const Units &units)
  {
    Material material = parse_elasticity(in, units);
    if (const Entry density = in["Density"]; !density.is_empty())
      {
        material.density = density.number();
        if (*material.density < 0.)
          density.refuse("entry.is-negative: the density must not be negative");
      }
    if (const auto expansion = parse_expansion(in["Thermal expansion"]))
      material.expansion = expansion;
    parse_strengths(in, material);
    return material;
  }
} // namespace lamella
