// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_material_plausibility_h
#define lamella_material_plausibility_h

#include <lamella/base/units.h>
#include <lamella/material/material.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Returns a warning if moduli of @p material, named @p name in the scene,
  /// are outside of 1 MPa to 2 TPa, so that the unit is probably not that of
  /// @p units. Cores may be softer in their plane. Empty without doubt or
  /// without units.
  std::string
  moduli_warning(const std::string &name,
                 const Material    &material,
                 const Units       &units);

  /**
   * Returns warnings about numbers of @p material, named @p name, whose unit is
   * probably wrong: moduli_warning(), and numbers outside of the ranges
   *   strength / modulus          1e-4 to 0.3 (whiskers)
   *   ultimate strains            below 0.3
   *   G_12 / E_1, G_12 / E_2      1e-3 to 10; of plies (E_3 <= E_1), not of
   *   G_13 / E_1, G_23 / E_2      cores, 13 and 23 as well
   *   density                     5 to 25,000 kg/m^3 (foams, osmium)
   *   thermal expansion           below 1e-3 / K (rubbers have 3e-4)
   * Ratios are checked without @p units, too. The worst of each kind is named.
   */
  std::vector<std::string>
  material_warnings(const std::string &name,
                    const Material    &material,
                    const Units       &units);

  /// Returns the largest Young's modulus of @p material, with its name.
  std::pair<const char *, double>
  largest_modulus(const Material &material);
} // namespace lamella

#endif
