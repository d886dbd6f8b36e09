// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_interior_point_h
#define lamella_solve_interior_point_h

#include <lamella/base/arithmetic.h>
#include <lamella/solve/contact_problem.h>
#include <lamella/solve/interface_system.h>

namespace lamella
{
  /// Tolerances of solve_by_interior_point(). Lengths are relative to the
  /// largest gap, and forces to the largest force of the starting point.
  struct InteriorPointParameters
  {
    /// The iteration ends if the mean product of gap and normal force falls
    /// below this fraction of the scales, or after `max_iterations`.
    /// Points with little force at little gap then have 1e-9 of both.
    double tolerance = 100. * arithmetic::rounding_of_solutions *
                       arithmetic::rounding_of_solutions;
    unsigned int max_iterations = 60;  ///< Maximum number of steps.
    double       first_gap      = 0.1; ///< Initial gap of each point.
    double       first_force    = 0.1; ///< Initial normal force of each point.
    /// Fraction of the step to the boundary of the feasible set.
    double to_boundary = 0.9995;
    /// A point whose force over gap falls below this ratio has no shear force.
    double opening = 1e-2;
  };

  /**
   * Solves contact with Coulomb friction approximately, by a primal-dual
   * interior point method that starts from no information: it finds the open,
   * sticking and slipping points in a number of factorizations that hardly
   * grows with the number of points. The last digits are left to Newton's
   * method. Returns the contact force of each point, zero where it is open;
   * the iterate of @p system has the gaps and slips. @p monitor is called
   * after each step. Throws NumericsError if a matrix cannot be factorized.
   *
   * With the lengths (v_n, v_t) of a point, the compliance of the law included,
   * and the bound b = mu lambda_n of the last iterate, which is constant in
   * each Newton step, the equations are
   *   v_n = s,                  s lambda_n = sigma,
   *   v_t + gamma lambda_t = 0, gamma (b^2 - |lambda_t|^2) = sigma b,
   * with s, lambda_n, gamma > 0 and |lambda_t| < b. The parameter sigma
   * decreases to zero by Mehrotra's rule (SIAM J. Optim. 2 (1992) 575-601).
   */
  PointVectors
  solve_by_interior_point(InterfaceSystem               &system,
                          const InterfacePoints         &points,
                          const Monitor                 &monitor,
                          const InteriorPointParameters &parameters = {});
} // namespace lamella

#endif
