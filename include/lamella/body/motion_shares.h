// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_motion_shares_h
#define lamella_body_motion_shares_h

#include <lamella/body/body.h>

#include <array>

namespace lamella
{
  /// Kinds of motion of a beam, in axes of the body. The first four are rigid
  /// motions of cross-sections, the others deform them.
  enum class Motion : unsigned int
  {
    bending_x, ///< u_z and rotation about x of cross-sections.
    bending_z, ///< u_x and rotation about z.
    axial,     ///< u_y.
    torsion,   ///< Rotation about y.
    width,     ///< Remaining u_x: change of the section's width.
    warping,   ///< Remaining u_y: warping of cross-sections.
    thickness  ///< Remaining u_z: change of the section's thickness.
  };

  /// Names of the kinds of motion in tables, in their order.
  inline constexpr std::array<const char *, 7> motion_names{{"bending about x",
                                                             "bending about z",
                                                             "axial",
                                                             "torsion",
                                                             "width",
                                                             "warping",
                                                             "thickness"}};

  /// Shares of each Motion in the kinetic energy of a mode; their sum is 1.
  using MotionShares = std::array<double, motion_names.size()>;

  /// Returns the shares of the motions in the kinetic energy int rho |v|^2 / 2
  /// dV of the velocity @p v (DoFs) of @p body at the DoFs @p u, with a density
  /// @p rho of each ply (equal if empty). In each cross-section, v is projected
  /// onto the rigid motions. Two Gauss points per element and coordinate.
  MotionShares
  motion_shares(const Body                &body,
                const std::vector<double> &rho,
                const Vector              &u,
                const Vector              &v);
} // namespace lamella

#endif
