// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_solid_parameters_h
#define lamella_body_solid_parameters_h

#include <lamella/base/entry.h>
#include <lamella/body/hexahedral_mesh.h>
#include <lamella/body/placement.h>

#include <deal.II/base/parameter_handler.h>

namespace lamella
{
  /// Entries of `subsection Kinematics` for the mesh of a solid, with defaults:
  ///   Refinements    divisions of all hexahedra into eight           (0)
  ///   Refine near    further divisions of hexahedra in balls,
  ///                  `x, y, z: radius: times`, separated by '|'      (none)
  /// Balls are in scene axes. Beams ignore both entries.
  struct SolidParameters
  {
    /// Declares the entries in the current subsection of @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the mesh refinement of a body at @p placement, with balls in
    /// body axes. Throws InputError for an invalid ball, a radius that is not
    /// positive, and more than 8 divisions.
    static SolidRefinement
    parse(const Entries &in, const Placement &placement);
  };
} // namespace lamella

#endif
