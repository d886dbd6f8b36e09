// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_field_rows_h
#define lamella_recover_field_rows_h

#include <lamella/body/body.h>

#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Ply number of a mean over several plies: -1, shown as 0 in tables from 1.
  constexpr unsigned int several_plies = dealii::numbers::invalid_unsigned_int;

  /// The fields at a point on one side of ply interfaces: a row of tables.
  struct FieldRow
  {
    /// Name of the body.
    std::string body;
    /// Ply, from 0 at the bottom (tables count from 1), or `several_plies`.
    unsigned int ply = 0;
    /// Undeformed position in the scene; the center of a box.
    dealii::Point<3> position;
    /// Displacement, strains and stresses, scene axes and ply axes.
    FieldSample sample;
  };

  /// A row of a line.
  struct LineRow
  {
    /// Arc length from the start. Both sides of a ply interface have the same.
    double   s = 0.;
    FieldRow fields;
  };

  /// A row of a cut: point (i, j) of the grid on cell @p cell of the section;
  /// points between two cells occur once per cell.
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
    /// Largest jump of the traction sigma . d, d the line's direction, over the
    /// largest stress component on the line. Equilibrium makes it zero where
    /// the line is normal to the plies; the rest is discretization error.
    double of_stress = 0.;
    /// Largest jump over the largest traction on the line; 0 for rounding.
    double of_traction = 0.;
  };

  /// Relative closure errors of stresses by equilibrium for each probe, line
  /// and cut: the largest difference from the traction on the upper face over
  /// the largest transverse stress (recover/interlaminar.h).
  struct EquilibriumDefects
  {
    std::vector<std::optional<double>> probes, lines, cuts;
  };
} // namespace lamella

#endif
