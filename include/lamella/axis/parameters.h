// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_axis_parameters_h
#define lamella_axis_parameters_h

#include <lamella/axis/axis.h>
#include <lamella/base/entry.h>

#include <deal.II/base/parameter_handler.h>

namespace lamella
{
  /**
   * The entries of a body's `subsection Kinematics` that speak of its axis, the
   * one-dimensional mesh and the beam element on it:
   *   Axis element     B2, B3 or B4                    (B4)
   *   Axis elements    a number, one for each piece,
   *                    or auto [FACTOR]                (10)
   *   Axis breaks      distances that end a piece      (none)
   *   Axis nodes       Gauss-Lobatto or equidistant    (Gauss-Lobatto)
   *   Shear strains    auto, assumed or full           (auto)
   * in parentheses what counts where nothing is said. `auto` assumes the
   * transverse shear strains of B2 and B3, which lock otherwise, and takes
   * those of B4 as the displacements give them.
   */
  struct AxisParameters
  {
    /// Declares them in the subsection that @p prm stands in.
    static void
    declare(dealii::ParameterHandler &prm);

    /// The mesh of an axis of @p length, the scene's, from the entries @p in of
    /// that subsection. Throws InputError for breaks that do not ascend within
    /// the length, and unless each piece between them has its number of
    /// elements, a whole one from 1 to 100000.
    static AxisMesh
    parse(const Entries &in, const double length);
  };
} // namespace lamella

#endif
