// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_material_parameters_h
#define lamella_material_parameters_h

#include <lamella/base/entry.h>
#include <lamella/base/units.h>
#include <lamella/material/material.h>

#include <deal.II/base/parameter_handler.h>

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
} // namespace lamella

#endif
