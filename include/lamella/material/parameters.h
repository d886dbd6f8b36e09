// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_material_parameters_h
#define lamella_material_parameters_h

#include <lamella/base/entry.h>
#include <lamella/base/units.h>
#include <lamella/material/material.h>

#include <deal.II/base/parameter_handler.h>

namespace lamella
{
  /// The entries of a `subsection Material NAME`: one of `Library`,
  /// `Engineering constants` (nine) and `Isotropic` (E, nu); optionally
  /// `Strengths` (nine, which replace the library's), `Ultimate strains`
  /// (nine), `Yield`, `Core strengths` (three), `Puck inclinations`.
  struct MaterialParameters
  {
    /// Declares the entries in the subsection that @p prm is in.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the material in the stresses of @p units. Throws InputError
    /// unless exactly one of the three entries is given, with valid constants;
    /// and for a library material, except hertz-200, in a scene without units.
    static Material
    parse(const Entries &in, const Units &units);
  };
} // namespace lamella

#endif
