// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_material_parameters_h
#define lamella_material_parameters_h

#include <lamella/base/entry.h>
#include <lamella/base/units.h>
#include <lamella/material/material.h>

#include <deal.II/base/parameter_handler.h>

namespace lamella
{
  /// The entries of a `subsection Material NAME`. `Library`, `Engineering
  /// constants` (nine) or `Isotropic` (E, nu), one of the three; moduli in the
  /// scene's unit of stress. What it bears, all optional: `Strengths` (nine,
  /// which take the place of those of the library), `Ultimate strains` (nine),
  /// `Yield`, `Core strengths` (three), `Puck inclinations`.
  struct MaterialParameters
  {
    /// Declares them in the subsection that @p prm is in.
    static void
    declare(dealii::ParameterHandler &prm);

    /// The material in the stresses of @p units. Throws InputError unless
    /// exactly one entry is given and the constants are positive definite. It
    /// also refuses a material of the library, whose constants have units, in a
    /// scene without units, but for hertz-200; nu outside of (-1, 1/2); and any
    /// number of constants but nine or two.
    static Material
    parse(const Entries &in, const Units &units);
  };
} // namespace lamella

#endif
