// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_solid_parameters_h
#define lamella_body_solid_parameters_h

#include <lamella/base/entry.h>
#include <lamella/body/hexahedral_mesh.h>
#include <lamella/body/placement.h>

#include <deal.II/base/parameter_handler.h>

namespace lamella
{
  /// Mesh entries of a solid in `subsection Kinematics`, divisions in eight:
  ///   Refinements    how often all of them are                       (0)
  ///   Refine near    then those that reach into a ball,
  ///                  `x, y, z: radius: times`, between '|'           (none)
  /// with defaults in parentheses and balls in scene axes. Beams ignore both.
  struct SolidParameters
  {
    /// Declares the entries in the current subsection of @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the refinement of a body at @p placement, balls in body axes.
    /// Throws InputError for a ball of other spelling or without a positive
    /// radius, and for more than 8 divisions. HexahedralMesh checks the rest.
    static SolidRefinement
    parse(const Entries &in, const Placement &placement);
  };
} // namespace lamella

#endif
