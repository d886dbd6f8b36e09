// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_field_rows_h
#define lamella_recover_field_rows_h

#include <lamella/body/body.h>

#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Ply number of a mean over several plies; 0 in tables, which count from 1.
  constexpr unsigned int several_plies = dealii::numbers::invalid_unsigned_int;

  /// Fields at a point, on one side of ply interfaces: a row of output tables.
  struct FieldRow
  {
    /// Name of the body.
    std::string body;
    /// Ply, from 0 at the bottom (tables count from 1), or `several_plies`.
    unsigned int ply = 0;
    /// Undeformed position in the scene; the center of a box.
    dealii::Point<3> position;
    /// Displacement, strains and stresses, in scene axes and ply axes.
    FieldSample sample;
  };

  /// A row of the output of a line.
  struct LineRow
  {
    /// Arc length from the start, equal on both sides of a ply interface.
    double   s = 0.;
    FieldRow fields;
  };

  /// A row of the output of a cut: point (i, j) of the grid on section cell
  /// @p cell. Points between two cells occur once per cell.
  struct CutRow
  {
    unsigned int cell = 0, i = 0, j = 0;
    FieldRow     fields;
  };

  /// Jumps of the traction at the ply interfaces that a line crosses.
  struct InterfaceJump
  {
    /// Number of interfaces that the line crosses.
    unsigned int interfaces = 0;
    /// Largest jump of the traction sigma . d, with the direction d of the
    /// line, over the largest stress component on the line. It is a
    /// discretization error if the line is normal to the plies.
    double of_stress = 0.;
    /// Largest jump over the largest traction on the line; 0 if rounding.
    double of_traction = 0.;
  };

  /// Relative equilibrium defects of `equilibrium` stresses for each probe,
  /// line and cut: the largest difference from the traction on the upper face
  /// over the largest transverse stress (recover/interlaminar.h).
  struct EquilibriumDefects
  {
    std::vector<std::optional<double>> probes, lines, cuts;
  };
} // namespace lamella

#endif
