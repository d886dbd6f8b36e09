// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_shape_change_h
#define lamella_section_shape_change_h

#include <lamella/section/saint_venant.h>

#include <array>

namespace lamella
{
  /**
   * Returns the effect of curvatures on stiffness by the change of a section's
   * shape, the c [length^2] of
   *   M = D k (1 + c k^2 + ...)
   * for the curvature about x, the twist about y and the curvature about z [rad
   * / length], in this order, each alone with the section free otherwise. It
   * contains Brazier's flattening of bent tubes (c < 0), Lamb's anticlastic
   * strip and Wagner's twisted one (c > 0): Green's strain at second order,
   *   c = 2 (int e_2 . C e_2 + 2 e_3 . C e_1 dA - f . v) / int e_1 . C e_1 dA
   * with the Saint-Venant state e_1 = B u_1 of k = 1. e_2 is quadratic in u_1
   * in axes that rotate with the section, H_i . H_j / 2 and the curvature of
   * warped points; e_3 is the latter times u_1. v relaxes e_2 and the work f of
   * the stress C e_1 on terms bilinear in u_1 and v (the section's modal
   * derivative), with free stretch of the axis.
   *
   * The result estimates what GeometricallyExactBeam neglects. It is valid if
   * small: wide strips flatten in a layer at their edges beyond b^2 k / h = 1.
   * For the section of an LE with the @p states.
   */
  std::array<double, 3>
  stiffening_by_shape(const SaintVenant &states);
} // namespace lamella

#endif
