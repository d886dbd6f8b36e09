// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/material/plausibility.h>

#include <utility>
#include <vector>

namespace lamella
{
  std::string
  doubt_of_moduli(const std::string &name,
                  const Material    &material,
                  const Units       &units)
  {
    // Of soft foams and of diamond, in pascals.
    constexpr double softest = 1e6, stiffest = 2e12;
    if (units.stress.empty())
      return "";
    const EngineeringConstants &c = material.elastic;
    std::vector<std::string>    odd;
    for (const auto &[what, modulus] : {std::make_pair("E1", c.E1),
                                        std::make_pair("E2", c.E2),
                                        std::make_pair("E3", c.E3),
                                        std::make_pair("G12", c.G12),
                                        std::make_pair("G13", c.G13),
                                        std::make_pair("G23", c.G23)})
      if (modulus < softest * units.pascal || modulus > stiffest * units.pascal)
        odd.push_back(std::string(what) + " = " + to_text(modulus) + " " +
                      units.stress);
    if (odd.empty())
      return "";
    return "material " + name + ": " + joined(odd) +
           (odd.size() == 1 ? " lies" : " lie") +
           " outside of 1 MPa to 2 TPa, where moduli of solids are. Units = " +
           units.length + ", " + units.force + " has stresses in " +
           units.stress + "; check that numbers are in it";
  }
} // namespace lamella
