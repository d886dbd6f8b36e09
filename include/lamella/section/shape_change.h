// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_shape_change_h
#define lamella_section_shape_change_h

#include <lamella/section/saint_venant.h>

#include <array>

namespace lamella
{
  /// Returns the nonlinear change of the bending and torsional stiffness due to
  /// the deformation of the section's shape, the coefficients c [length^2] of
  ///   M = D k (1 + c k^2 + ...)
  /// for the curvature k about x, the twist k about y and the curvature k about
  /// z [rad / length], in this order. Examples are Brazier's flattening of bent
  /// tubes (c < 0), Lamb's anticlastic bending of strips and Wagner's twisted
  /// strip (c > 0). From Green's strain at second order in k,
  ///   c = 2 (int e_2 . C e_2 + 2 e_3 . C e_1 dA - f . v) / int e_1 . C e_1 dA
  /// where e_1 is the strain of the Saint-Venant state u_1 for k = 1, and e_2
  /// the part of the strain quadratic in u_1 in axes that rotate with the
  /// section: H_i . H_j / 2, with the displacement gradient H, and the
  /// curvature of warped points. e_3 is cubic, the curvature term times u_1. v
  /// is the displacement (modal derivative) that relaxes e_2 under the forces
  /// f, the work of the stress C e_1 on terms bilinear in u_1 and v. The axis
  /// can stretch.
  ///
  /// The result estimates the error of GeometricallyExactBeam, which neglects
  /// this effect. It is valid only if c k^2 is small; strips of width b and
  /// thickness h flatten in edge layers beyond b^2 k / h = 1. The section of
  /// @p states must be of LE.
  std::array<double, 3>
  stiffening_by_shape(const SaintVenant &states);
} // namespace lamella

#endif
