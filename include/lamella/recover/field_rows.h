// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_field_rows_h
#define lamella_recover_field_rows_h

#include <lamella/body/body.h>

#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// One less than 0: tables, which count plies from 1, have 0 there.
  constexpr unsigned int several_plies = dealii::numbers::invalid_unsigned_int;

  /// The fields at a point of a body, on one side of its ply interfaces: a row
  /// of the tables of probes, lines and cuts.
  struct FieldRow
  {
    /// Its name.
    std::string body;
    /// From 0 at the bottom; tables count from 1. `several_plies` of a mean
    /// over a box that reaches into more than one.
    unsigned int ply = 0;
    /// Undeformed, in the scene; the middle of a box.
    dealii::Point<3> position;
    /// Displacement, strains and stresses, scene axes and ply axes.
    FieldSample sample;
  };

  /// A row of a line, with the arc length from its start.
  struct LineRow
  {
    /// A length; both sides of a ply interface have the same.
    double   s = 0.;
    FieldRow fields;
  };

  /// A row of a cut: point (i, j) of the grid on the cell number @p cell of the
  /// section, each from 0. Cells have grids of their own, so points on their
  /// common sides stand there once a cell.
  struct CutRow
  {
    unsigned int cell = 0, i = 0, j = 0;
    FieldRow     fields;
  };

  /// What a line meets at the ply interfaces that it crosses.
  struct InterfaceJump
  {
    /// 0: it crosses none.
    unsigned int interfaces = 0;
    /// The largest jump of the traction sigma . d, d the line's direction,
    /// over the largest stress component on the line: what the jump is to the
    /// body. Equilibrium makes it zero where the line is normal to the plies;
    /// what is left is the section's mesh.
    double of_stress = 0.;
    /// The same over the largest traction on the line: what it is to the
    /// transverse stresses. 0 where these are rounding.
    double of_traction = 0.;
  };

  /// What the integration of equilibrium leaves in the columns of each probe,
  /// line and cut whose stresses come of it: the largest difference from the
  /// traction on the upper face over the largest transverse stress, before it
  /// is distributed (recover/interlaminar.h). None for all others.
  struct Closures
  {
    std::vector<std::optional<double>> probes, lines, cuts;
  };
} // namespace lamella

#endif
