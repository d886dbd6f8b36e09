// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_ply_reserve_h
#define lamella_recover_ply_reserve_h

#include <deal.II/base/point.h>

#include <optional>
#include <string>

namespace lamella
{
  /// Reserve factor of a ply by one criterion (doc/theory/strength.md).
  struct PlyReserve
  {
    /// Number of the body in the scene; ply from 0 at the bottom.
    unsigned int body = 0, ply = 0;
    /// Criterion as in the scene, and failure mode.
    std::string criterion, mode;
    /// Factor on the loads at which the ply fails, with proportional stresses.
    std::optional<double> reserve;
    /// Value of the criterion: 1 at failure.
    double index = 0.;
    /// Undeformed position in the scene.
    dealii::Point<3> position;
    /// Angle from axis 2 of the ply to the fracture plane's normal, positive
    /// towards 3 [degrees], if any.
    std::optional<double> angle;
    /// |element - recovered stress| / |recovered|: the discretization error.
    double stress_discrepancy = 0.;
  };

  /// Smallest reserve factor of a ply at a station of a beam's axis.
  struct ReserveAlong
  {
    /// Number of the body in the scene; ply from 0 at the bottom.
    unsigned int body = 0, ply = 0;
    /// Distance from the axis' start, and the position in the scene.
    double           s = 0.;
    dealii::Point<3> position;
    /// Largest 1/R of the elements' stresses; none if the station is left out.
    std::optional<double> inverse_reserve;
  };
} // namespace lamella

#endif
