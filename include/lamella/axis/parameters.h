// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_axis_parameters_h
#define lamella_axis_parameters_h

#include <lamella/axis/axis.h>
#include <lamella/base/entry.h>

#include <deal.II/base/parameter_handler.h>

namespace lamella
{
  /**
   * The entries of a body's `subsection Kinematics` for its axis mesh and beam
   * element, with defaults in parentheses:
   *   Axis element     B2, B3 or B4                    (B4)
   *   Axis elements    a number, one for each piece,
   *                    or auto [FACTOR]                (10)
   *   Axis breaks      distances that end a piece      (none)
   *   Axis nodes       Gauss-Lobatto or equidistant    (Gauss-Lobatto)
   *   Shear strains    auto, assumed or full           (auto)
   * `auto` is `assumed` for B2 and B3, which lock otherwise, and `full` for B4.
   */
  struct AxisParameters
  {
    /// Declares the entries in the subsection that @p prm is in.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the mesh of an axis of @p length from the entries @p in. Throws
    /// InputError for breaks that do not ascend within the length, and unless
    /// each piece has from 1 to 100000 elements.
    static AxisMesh
    parse(const Entries &in, const double length);
  };
} // namespace lamella

#endif
