// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_field_rows_h
#define lamella_recover_field_rows_h

#include <lamella/body/body.h>

#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Value of FieldRow::ply for a mean over several plies; tables show 0.
  constexpr unsigned int several_plies = dealii::numbers::invalid_unsigned_int;

  /// Displacement, strains and stresses at a point of a body in one ply.
  struct FieldRow
  {
    std::string body; ///< Name of the body.
    /// Ply, from 0 at the bottom (tables count from 1), or `several_plies`.
    unsigned int ply = 0;
    /// Position in the undeformed scene [length]; for a box its center.
    dealii::Point<3> position;
    FieldSample      sample; ///< Displacement, strains and stresses there.
  };

  /// Fields at one point of an output line (`subsection Line NAME`).
  struct LineRow
  {
    double   s = 0.; ///< Arc length from the start of the line [length].
    FieldRow fields; ///< Fields at the point in one ply.
  };

  /// Fields at one point of an output cut (`subsection Cut NAME`), which has a
  /// grid of points on each section cell.
  struct CutRow
  {
    unsigned int cell = 0; ///< Index of the section cell.
    unsigned int i    = 0; ///< Index of the point along the first side, from 0.
    unsigned int j = 0;  ///< Index of the point along the second side, from 0.
    FieldRow     fields; ///< Fields at the point in the ply of the cell.
  };

  /// Jumps of the traction at the ply interfaces that an output line crosses.
  struct InterfaceJump
  {
    unsigned int interfaces = 0; ///< Number of ply interfaces on the line.
    /// Largest jump of the traction sigma . d, with the unit vector d along the
    /// line, divided by the largest stress component on the line. It is a
    /// discretization error if the line is normal to the plies.
    double of_stress = 0.;
    /// Largest jump of the traction divided by the largest traction on the
    /// line; 0 if the jump is within rounding.
    double of_traction = 0.;
  };

  /// Relative errors of transverse stresses from integrated equilibrium
  /// (`Stress = equilibrium`): the largest difference between the integrated
  /// stresses and the traction on the upper face of the laminate, divided by
  /// the largest transverse stress. A value is empty if the probe, line or cut
  /// requests other stresses.
  struct EquilibriumDefects
  {
    std::vector<std::optional<double>> probes; ///< Error of each probe.
    std::vector<std::optional<double>> lines;  ///< Error of each line.
    std::vector<std::optional<double>> cuts;   ///< Error of each cut.
  };
} // namespace lamella

#endif
