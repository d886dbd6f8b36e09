// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_material_parameters_h
#define lamella_material_parameters_h

#include <lamella/base/entry.h>
#include <lamella/base/units.h>
#include <lamella/material/material.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Declares and parses `subsection Material NAME`, which has exactly one of
  /// the entries `Library`, `Engineering constants` (9 numbers) and `Isotropic`
  /// (E, nu). Optional entries are `Strengths` (9 numbers, which replace the
  /// library's), `Ultimate strains` (9 numbers), `Yield`, `Core strengths` (3
  /// numbers) and `Puck inclinations`.
  struct MaterialParameters
  {
    /// Declares the entries of a material in the current subsection of @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the material that the entries @p in define. Values of library
    /// materials are converted to @p units. Throws InputError unless exactly
    /// one of Library, Engineering constants and Isotropic is set, for invalid
    /// constants, and for library materials (but hertz-200) without units.
    static Material
    parse(const Entries &in, const Units &units);
  };

  /// Returns a warning if the moduli of @p material are probably not in
  /// @p units: if all Young's moduli are below 1 MPa or a modulus is above 2
  /// TPa. The warning names the material @p name. The result is empty if the
  /// moduli are plausible or the scene has no units.
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
  /// Ratios are also checked in scenes without units. Each warning names the
  /// material @p name and the value farthest outside of the range.
  std::vector<std::string>
  material_warnings(const std::string &name,
                    const Material    &material,
                    const Units       &units);

  /// Returns the name (E1, E2 or E3) and the value [force/length^2] of the
  /// largest Young's modulus of @p material.
  std::pair<const char *, double>
  largest_modulus(const Material &material);
} // namespace lamella

#endif
