// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_solid_parameters_h
#define lamella_body_solid_parameters_h

#include <lamella/base/entry.h>
#include <lamella/body/hexahedral_mesh.h>
#include <lamella/body/placement.h>

#include <deal.II/base/parameter_handler.h>

namespace lamella
{
  /// Mesh entries of a solid in a body's `subsection Kinematics`, for hexahedra
  /// divided in eight:
  ///   Refinements    how often all of them are                       (0)
  ///   Refine near    then those that reach into a ball,
  ///                  `x, y, z: radius: times`, between '|'           (none)
  /// with defaults in parentheses. Balls are in scene axes and its unit of
  /// length, so that they can be put where two bodies touch. Beams ignore both.
  struct SolidParameters
  {
    /// Declares the entries in the current subsection of @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the refinement of a body at @p placement, its balls in body
    /// axes. Throws InputError for a ball of other spelling or without a
    /// positive radius, and unless hexahedra are divided 0 to 8 times.
    /// HexahedralMesh checks that balls meet the body and that the mesh fits in
    /// memory.
    static SolidRefinement
    parse(const Entries &in, const Placement &placement);
  };
} // namespace lamella

#endif
