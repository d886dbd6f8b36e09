// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_material_parameters_h
#define lamella_material_parameters_h

#include <lamella/base/units.h>
#include <lamella/material/material.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace lamella
{
  /// The entries of a `subsection Material NAME`.
  struct MaterialParameters
  {
    std::string library, engineering_constants, isotropic;

    static void
    declare(dealii::ParameterHandler &prm);

    static MaterialParameters
    parse(const dealii::ParameterHandler &prm);

    /// The material in the stresses of @p units. Throws InputError, beginning
    /// with @p what (`Material NAME`), unless exactly one entry is given and
    /// the constants are positive definite.
    Material
    material(const Units &units, const std::string &what) const;
  };
} // namespace lamella

#endif
