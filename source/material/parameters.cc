// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
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
      Anything(),
      "Orthotropic: E1, E2, E3, G12, G13, G23, nu12, nu13, nu23 "
      "with 1 along the fibre and 3 normal to the ply, in the "
      "scene's stresses.");
    prm.declare_entry("Isotropic",
                      "",
                      Anything(),
                      "E, nu of an isotropic material, E in the scene's "
                      "stresses.");
  }



  MaterialParameters
  MaterialParameters::parse(const ParameterHandler &prm)
  {
    return {prm.get("Library"),
            prm.get("Engineering constants"),
            prm.get("Isotropic")};
  }



  Material
  MaterialParameters::material(const Units       &units,
                               const std::string &what) const
  {
    const int given =
      !library.empty() + !engineering_constants.empty() + !isotropic.empty();
    if (given != 1)
      throw InputError(what +
                       ": give exactly one of Library, Engineering "
                       "constants and Isotropic; " +
                       (given == 0 ? "none is" : "several are") + " set.");

    Material    material;
    std::string entry;
    if (!library.empty())
      {
        try
          {
            material = library_material(library, units);
            if (units.stress.empty() && library != "hertz-200")
              throw InputError("Library = " + library +
                               ": its constants have units, but Units is none. "
                               "Set Units = m, N or mm, N.");
          }
        catch (const InputError &error)
          {
            throw InputError(what + "/" + error.what());
          }
      }
    else if (!isotropic.empty())
      {
        entry              = what + "/Isotropic = " + isotropic;
        const auto numbers = to_numbers(isotropic, what + "/Isotropic");
        if (numbers.size() != 2)
          throw InputError(entry + ": must be two numbers, E and nu.");
        if (!(numbers[1] > -1. && numbers[1] < 0.5))
          throw InputError(entry + ": nu must lie between -1 and 0.5, or the "
                                   "material is not positive definite.");
        material.elastic =
          EngineeringConstants::isotropic(numbers[0], numbers[1]);
      }
    else
      {
        entry = what + "/Engineering constants = " + engineering_constants;
        const auto n =
          to_numbers(engineering_constants, what + "/Engineering constants");
        if (n.size() != 9)
          throw InputError(entry +
                           ": must be nine numbers, E1, E2, E3, G12, "
                           "G13, G23, nu12, nu13, nu23; there are " +
                           std::to_string(n.size()) + ".");
        material.elastic = {
          n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8]};
      }
    const std::string violated = material.elastic.violated_condition();
    if (!violated.empty())
      throw InputError(
        entry + ": the material is not positive definite: " + violated + ".");
    return material;
  }
} // namespace lamella
