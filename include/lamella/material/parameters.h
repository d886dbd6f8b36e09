// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_material_parameters_h
#define lamella_material_parameters_h

#include <lamella/base/entry.h>
#include <lamella/base/units.h>
#include <lamella/material/material.h>

#include <deal.II/base/parameter_handler.h>

namespace lamella
{
  /// Declares and parses a `subsection Material NAME`. It has exactly one of
  /// the entries `Library`, `Engineering constants` (9 numbers) and `Isotropic`
  /// (E, nu). Optional are `Strengths` (9, instead of the library's), `Ultimate
  /// strains` (9), `Yield`, `Core strengths` (3) and `Puck inclinations`.
  struct MaterialParameters
  {
    /// Declares the entries in the current subsection of @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the material, with library values converted to @p units. Throws
    /// InputError if not exactly one of the three entries is set, for invalid
    /// constants, and for library materials without units (except hertz-200).
    static Material
    parse(const Entries &in, const Units &units);
  };
} // namespace lamella

#endif
