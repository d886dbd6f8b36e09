// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_cone_minimum_h
#define lamella_solve_cone_minimum_h

#include <lamella/solve/point_compliance.h>

namespace lamella
{
  /// Returns the minimum of 1/2 x . W x + q . x over vectors x with the
  /// components of each contact point in the Lorentz cone |x_t| <= x_n. It is
  /// unique if W is positive definite. Interior-point method with Nesterov-Todd
  /// scaling and Mehrotra's predictor (Andersen, Roos and Terlaky, Math.
  /// Program. 95 (2003) 249-277): 10 to 25 factorizations of W plus a
  /// block-diagonal matrix. Returns the last iterate if it does not converge.
  PointVectors
  cone_minimum(const PointCompliance &W, const PointVectors &q);
} // namespace lamella

#endif
