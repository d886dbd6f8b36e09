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
  /// with moment M and stiffness D, for the curvature k about x, the twist k
  /// about y and the curvature k about z [rad / length], in this order.
  /// Examples: Brazier's flattening of bent tubes (c < 0), Lamb's anticlastic
  /// bending of strips and Wagner's twisted strip (c > 0). From Green's strain
  /// up to second order in k,
  ///   c = 2 (int e_2 . C e_2 + 2 e_3 . C e_1 dA - f . v) / int e_1 . C e_1 dA
  /// with the elasticity matrix C, the strain e_1 of the Saint-Venant
  /// displacement u_1 for k = 1, and the quadratic and cubic strains e_2 and
  /// e_3 of u_1 in axes that rotate with the section. The forces f on v are due
  /// to C e_2, and to C e_1 by strains bilinear in u_1 and v. Under them, v
  /// (modal derivative) relaxes the section. The axis can stretch.
  /// The result estimates the error of GeometricallyExactBeam, which neglects
  /// this effect. It is valid only if c k^2 is small; strips of width b and
  /// thickness h flatten in edge layers if b^2 k / h > 1. @p states are the
  /// Saint-Venant solutions of a section with Lagrange expansion LE.
  std::array<double, 3>
  stiffening_by_shape(const SaintVenant &states);
} // namespace lamella

#endif
