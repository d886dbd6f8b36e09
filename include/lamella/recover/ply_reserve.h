// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_ply_reserve_h
#define lamella_recover_ply_reserve_h

#include <deal.II/base/point.h>

#include <optional>
#include <string>

namespace lamella
{
  /// How near a ply of a body is to failure by one criterion, at the place that
  /// is nearest to it (doc/strength.md).
  struct PlyReserve
  {
    /// The body's number in the scene; the ply from 0 at the bottom.
    unsigned int body = 0, ply = 0;
    /// As the scene writes it, and what fails.
    std::string criterion, mode;
    /// What loads may be multiplied with, stresses growing with them; none
    /// where no factor brings failure.
    std::optional<double> reserve;
    /// The criterion's value: 1 at failure.
    double index = 0.;
    /// Undeformed, in the scene.
    dealii::Point<3> position;
    /// From the axis 2 of the ply to the normal of the fracture plane, positive
    /// towards 3, in degrees, where the criterion has such a plane.
    std::optional<double> angle;
    /// |element's stress - recovered stress| / |recovered stress| there: what
    /// the mesh leaves open. Large where stress is singular.
    double doubt = 0.;
  };

  /// The nearest to failure that a ply comes at a station of a beam's axis, by
  /// any criterion and anywhere across the section.
  struct ReserveAlong
  {
    /// The body's number in the scene; the ply from 0 at the bottom.
    unsigned int body = 0, ply = 0;
    /// The distance from the axis' start, and the place in the scene.
    double           s = 0.;
    dealii::Point<3> position;
    /// The largest 1/R of the elements' own stresses; 0 where no R is finite,
    /// none where all of the station is left out.
    std::optional<double> inverse_reserve;
  };
} // namespace lamella

#endif
