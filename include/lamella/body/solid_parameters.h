// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_solid_parameters_h
#define lamella_body_solid_parameters_h

#include <lamella/body/hexahedral_mesh.h>
#include <lamella/body/placement.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace lamella
{
  /// The entries of a body's `subsection Kinematics` that speak of the mesh of
  /// a solid.
  struct SolidParameters
  {
    std::string refinements, near;

    static void
    declare(dealii::ParameterHandler &prm);

    static SolidParameters
    parse(const dealii::ParameterHandler &prm);

    /// The refinement of a body at @p placement. Throws InputError, beginning
    /// with @p what (`Body NAME/Kinematics`).
    SolidRefinement
    refinement(const Placement &placement, const std::string &what) const;
  };
} // namespace lamella

#endif
