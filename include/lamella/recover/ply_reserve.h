// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_ply_reserve_h
#define lamella_recover_ply_reserve_h

#include <deal.II/base/point.h>

#include <optional>
#include <string>

namespace lamella
{
  /// Smallest reserve factor of a ply by one failure criterion, and its point
  /// (doc/theory/strength.md).
  struct PlyReserve
  {
    unsigned int body = 0;  ///< Index of the body in the scene, from 0.
    unsigned int ply  = 0;  ///< Index of the ply, from 0 at the bottom.
    std::string  criterion; ///< Name of the failure criterion in the scene.
    std::string  mode;      ///< Failure mode, such as `fiber tension`.
    /// Factor on mechanical stresses at which the ply fails; empty if the ply
    /// does not fail at any factor.
    std::optional<double> reserve;
    /// Value of the failure criterion at the computed stresses; 1 at failure.
    double index = 0.;
    /// Position of the point in the undeformed scene [length].
    dealii::Point<3> position;
    /// Angle from axis 2 of the ply to the normal of the fracture plane,
    /// positive towards axis 3 [degrees]; empty if unknown.
    std::optional<double> angle;
    /// Stress error: |element stress - recovered stress| / |recovered stress|.
    double stress_discrepancy = 0.;
  };

  /// Smallest reserve factor of a ply in one cross-section of a beam.
  struct ReserveAlong
  {
    unsigned int     body = 0; ///< Index of the body in the scene, from 0.
    unsigned int     ply  = 0; ///< Index of the ply, from 0 at the bottom.
    double           s = 0.; ///< Distance from the start of the axis [length].
    dealii::Point<3> position; ///< Point of the undeformed axis [length].
    /// Largest inverse reserve factor by element stresses in the cross-section;
    /// empty if an excluded box of `subsection Strength` contains it.
    std::optional<double> inverse_reserve;
  };
} // namespace lamella

#endif
