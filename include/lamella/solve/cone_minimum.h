// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_cone_minimum_h
#define lamella_solve_cone_minimum_h

#include <lamella/solve/point_compliance.h>

namespace lamella
{
  /// Returns the minimizer of 1/2 x . W x + q . x over vectors x with the
  /// components (x_n, x_t) of each contact point in the cone |x_t| <= x_n. It
  /// is unique if W is positive definite. Interior-point method with
  /// Nesterov-Todd scaling and Mehrotra's predictor (Andersen, Roos and
  /// Terlaky, Math. Program. 95 (2003) 249-277): 10 to 25 factorizations of W
  /// plus a block-diagonal matrix. Without convergence, the last iterate.
  PointVectors
  cone_minimum(const PointCompliance &W, const PointVectors &q);
} // namespace lamella

#endif
