// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_axis_parameters_h
#define lamella_axis_parameters_h

#include <lamella/axis/axis.h>
#include <lamella/base/entry.h>

#include <deal.II/base/parameter_handler.h>

namespace lamella
{
  /// The entries for the mesh of the axis in a body's `subsection Kinematics`,
  /// with defaults in parentheses:
  ///   Axis element     B2, B3 or B4                    (B4)
  ///   Axis elements    numbers of elements, one per interval,
  ///                    or auto [FACTOR]                (10)
  ///   Axis breaks      y that end an interval          (none)
  ///   Axis nodes       Gauss-Lobatto or equidistant    (Gauss-Lobatto)
  ///   Shear strains    auto, assumed or full           (auto)
  /// For shear strains, `auto` means `assumed` for B2 and B3, which otherwise
  /// lock in shear, and `full` for B4.
  struct AxisParameters
  {
    /// Declares the entries in the current subsection of @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the mesh of an axis of @p length from the entries @p in. Throws
    /// InputError if the breaks do not ascend between 0 and @p length, or if an
    /// interval does not have 1 to 100000 elements.
    static AxisMesh
    parse(const Entries &in, const double length);
  };
} // namespace lamella

#endif
