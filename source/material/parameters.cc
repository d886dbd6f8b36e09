// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/patterns.h>
#include <lamella/material/library.h>
#include <lamella/material/parameters.h>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

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
      "Orthotropic: E1, E2, E3, G12, G13, G23, nu12, nu13, nu23 "
      "with 1 along the fibre and 3 normal to the ply, in the "
      "scene's stresses.");
    prm.declare_entry("Isotropic",
                      "",
                      patterns::numbers(),
                      "E, nu of an isotropic material, E in the scene's "
                      "stresses.");
  }



  namespace
  {
    Material
    parse_library(const Entry &entry, const Units &units)
    {
      const Material material = library_material(entry, units);
      if (units.stress.empty() && entry.text() != "hertz-200")
        entry.refuse("its constants have units, but Units is none",
                     "Set Units = m, N or mm, N.");
      return material;
    }



    EngineeringConstants
    parse_isotropic(const Entry &entry)
    {
      const std::vector<double> numbers = entry.numbers();
      if (numbers.size() != 2)
        entry.refuse("must be two numbers, E and nu");
      if (!(numbers[1] > -1. && numbers[1] < 0.5))
        entry.refuse("nu must lie between -1 and 0.5, or the material is not "
                     "positive definite");
      return EngineeringConstants::isotropic(numbers[0], numbers[1]);
    }



    EngineeringConstants
    parse_orthotropic(const Entry &entry)
    {
      const std::vector<double> n = entry.numbers();
      if (n.size() != 9)
        entry.refuse("must be nine numbers, E1, E2, E3, G12, G13, G23, nu12, "
                     "nu13, nu23; there are " +
                     std::to_string(n.size()));
      return {n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8]};
    }
  } // namespace



  Material
  MaterialParameters::parse(const Entries &in, const Units &units)
  {
    const Entry library = in["Library"], isotropic = in["Isotropic"],
                orthotropic = in["Engineering constants"];
    const int given =
      !library.is_empty() + !orthotropic.is_empty() + !isotropic.is_empty();
    if (given != 1)
      in.refuse(
        std::string("give exactly one of Library, Engineering constants and "
                    "Isotropic; ") +
        (given == 0 ? "none is" : "several are") + " set");
    if (!library.is_empty())
      return parse_library(library, units);

    const EngineeringConstants elastic  = isotropic.is_empty() ?
                                            parse_orthotropic(orthotropic) :
                                            parse_isotropic(isotropic);
    const std::string          violated = elastic.violated_condition();
    if (!violated.empty())
      (isotropic.is_empty() ? orthotropic : isotropic)
        .refuse("the material is not positive definite: " + violated);
    return elastic;
  }
} // namespace lamella
