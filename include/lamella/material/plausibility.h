// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_material_plausibility_h
#define lamella_material_plausibility_h

#include <lamella/base/units.h>
#include <lamella/material/material.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Returns a warning if a modulus of @p material is outside of 1 MPa to 2
  /// TPa, so that it is probably not in @p units. @p name is the name of the
  /// material in the warning. Cores may be softer in their plane. The result is
  /// empty if the moduli are plausible or the scene has no units.
  std::string
  moduli_warning(const std::string &name,
                 const Material    &material,
                 const Units       &units);

  /// Returns warnings about values of @p material whose unit is probably wrong:
  /// moduli_warning(), and values outside of the ranges
  ///   strength / modulus          1e-4 to 0.3 (whiskers)
  ///   ultimate strains            below 0.3
  ///   G_12 / E_1, G_12 / E_2      1e-3 to 10
  ///   G_13 / E_1, G_23 / E_2      1e-3 to 10; only of plies (E_3 <= E_1)
  ///   density                     5 to 25,000 kg/m^3 (foams, osmium)
  ///   thermal expansion           below 1e-3 / K (rubbers have 3e-4)
  /// Ratios are checked also in scenes without units. Each warning names the
  /// worst value. @p name is the name of the material.
  std::vector<std::string>
  material_warnings(const std::string &name,
                    const Material    &material,
                    const Units       &units);

  /// Returns the name, e.g. E1, and the value of the largest Young's modulus.
  std::pair<const char *, double>
  largest_modulus(const Material &material);
} // namespace lamella

#endif
