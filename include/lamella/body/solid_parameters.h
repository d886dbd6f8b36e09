// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_solid_parameters_h
#define lamella_body_solid_parameters_h

#include <lamella/base/entry.h>
#include <lamella/body/hexahedral_mesh.h>
#include <lamella/body/placement.h>

#include <deal.II/base/parameter_handler.h>

namespace lamella
{
  /**
   * The entries of a body's `subsection Kinematics` that speak of the mesh of
   * a solid, hexahedra that are divided in eight:
   *   Refinements    how often all of them are                       (0)
   *   Refine near    then those that reach into a ball,
   *                  `x, y, z: radius: times`, between '|'           (none)
   * in parentheses what counts where nothing is said. Balls are in the scene's
   * axes and unit of length, so that they can be put where two bodies touch.
   * Beams ignore both.
   */
  struct SolidParameters
  {
    /// Declares them in the subsection that @p prm stands in.
    static void
    declare(dealii::ParameterHandler &prm);

    /// The refinement of a body at @p placement, its balls in the body's axes.
    /// Throws InputError for a ball that is not spelt like that or whose radius
    /// is not positive, and unless hexahedra are divided 0 to 8 times, each of
    /// which makes eight of one. Whether a ball meets the body and whether the
    /// mesh fits in memory is HexahedralMesh's to say.
    static SolidRefinement
    parse(const Entries &in, const Placement &placement);
  };
} // namespace lamella

#endif
