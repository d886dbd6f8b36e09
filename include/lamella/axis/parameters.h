// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_axis_parameters_h
#define lamella_axis_parameters_h

#include <lamella/axis/axis.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace lamella
{
  /// What a body's `subsection Kinematics` says of the axis.
  struct AxisParameters
  {
    std::string element, elements, breaks, nodes, shear_strains = "auto";

    static void
    declare(dealii::ParameterHandler &prm);

    static AxisParameters
    parse(const dealii::ParameterHandler &prm);

    /// The mesh of an axis of @p length. Throws InputError, beginning with
    /// @p what (`Body NAME/Kinematics`).
    AxisMesh
    mesh(const double length, const std::string &what) const;
  };
} // namespace lamella

#endif
