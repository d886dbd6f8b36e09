// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_shape_change_h
#define lamella_section_shape_change_h

#include <lamella/section/saint_venant.h>

#include <array>

namespace lamella
{
  /**
   * What curvatures do to the shape of a section, and that to its stiffness:
   * the c of
   *
   *     M = D k (1 + c k^2 + ...)
   *
   * [length^2] for the curvature k about x, the twist about y and the curvature
   * about z [rad / length], in this order, alone and with the section free
   * otherwise. That is Brazier's flattening of bent tubes (c < 0), Lamb's
   * anticlastic strip and Wagner's twisted one (c > 0): Green's strain at
   * second order,
   *
   *     c = 2 (int e_2 . C e_2 + 2 e_3 . C e_1 dA - f . v) / int e_1 . C e_1 dA
   *
   * where e_1 = B u_1 is the Saint-Venant state of k = 1; e_2 is what is
   * quadratic in u_1 in axes that turn with the section, H_i . H_j / 2 and the
   * curvature of what has warped; e_3 is the latter times u_1; and v is what
   * relaxes e_2 and the work of the stress C e_1 on what is bilinear in u_1 and
   * v, f (the section's modal derivative). The stretch of the axis is free in
   * v.
   *
   * An estimate for beams whose law leaves out most of it (ReissnerBeam), right
   * where it is small: wide strips flatten in a layer at their edges beyond b^2
   * k / h = 1. Of the section of an LE that has the @p states.
   */
  std::array<double, 3>
  stiffening_by_shape(const SaintVenant &states);
} // namespace lamella

#endif
