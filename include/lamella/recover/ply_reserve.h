// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_ply_reserve_h
#define lamella_recover_ply_reserve_h

#include <deal.II/base/point.h>

#include <optional>
#include <string>

namespace lamella
{
  /// Reserve factor of a ply by one failure criterion (doc/theory/strength.md).
  struct PlyReserve
  {
    /// Number of the body in the scene; ply number from 0 at the bottom.
    unsigned int body = 0, ply = 0;
    /// Criterion as in the scene, and failure mode.
    std::string criterion, mode;
    /// Factor on mechanical stresses at which the ply fails; empty if none.
    std::optional<double> reserve;
    /// Value of the failure criterion; 1 at failure.
    double index = 0.;
    /// Undeformed position in the scene.
    dealii::Point<3> position;
    /// Angle from axis 2 of the ply to the normal of the fracture plane,
    /// positive towards axis 3 [degrees]; empty if unknown.
    std::optional<double> angle;
    /// Stress error: |element stress - recovered stress| / |recovered stress|.
    double stress_discrepancy = 0.;
  };

  /// Smallest reserve factor of a ply in a section of a beam.
  struct ReserveAlong
  {
    /// Number of the body in the scene; ply number from 0 at the bottom.
    unsigned int body = 0, ply = 0;
    /// Distance from the start of the axis, and position in the scene.
    double           s = 0.;
    dealii::Point<3> position;
    /// Largest 1/R of the element stresses; empty if the section is excluded.
    std::optional<double> inverse_reserve;
  };
} // namespace lamella

#endif
