// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_cone_minimum_h
#define lamella_solve_cone_minimum_h

#include <lamella/solve/point_compliance.h>

namespace lamella
{
  /**
   * The minimum of 1/2 x . W x + q . x over x_i in the Lorentz cones
   * |x_t| <= x_n, a convex problem with one solution if W is positive definite:
   * by an interior point method with the scaling of Nesterov and Todd and the
   * predictor of Mehrotra (Andersen, Roos and Terlaky, Math. Program. 95 (2003)
   * 249-277). 10 to 25 factors of W with a block at each point, whatever the
   * size. What arithmetic bears of it, where that does not end: a start for
   * others.
   */
  PointVectors
  cone_minimum(const PointCompliance &W, const PointVectors &q);
} // namespace lamella

#endif
