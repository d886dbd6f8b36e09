// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_coulomb_h
#define lamella_solve_coulomb_h

#include <lamella/solve/interface_solver.h>

#include <vector>

namespace lamella
{
  /// Unilateral contact with Coulomb friction, reduced to the contact points by
  /// their dense compliance W. The gap v_n and the slip increment v_t of each
  /// point depend on the contact forces lambda as
  ///   v = q + W (lambda - lambda_0),
  /// with v = q at the forces lambda_0 = `about`. The forces satisfy
  ///   v_n >= 0,   lambda_n >= 0,   v_n lambda_n = 0,
  ///   |lambda_t| <= mu lambda_n,
  ///   v_t = 0 where |lambda_t| < mu lambda_n,
  ///   lambda_t = -mu lambda_n v_t / |v_t| where v_t is not zero.
  /// W may be singular. The solution is unique for small mu only.
  struct CoulombProblem
  {
    PointCompliance compliance; ///< Compliance W of the contact points.
    /// Gap and slip of each point under the forces `about`.
    PointVectors        q, about = {}; ///< Reference forces; zero if empty.
    std::vector<double> friction; ///< Friction coefficient mu of each point.
  };

  /// Tolerances and limits of solve_coulomb().
  struct CoulombRules
  {
    /// Compliance of each point (softened()), so that the problem is definite
    /// and its sets of points do not change by rounding; proximal iterations
    /// remove its effect.
    double compliance       = 1e-8;
    double least_compliance = 1e-10; ///< Smallest compliance.
    /// Factor of the compliance after a proximal iteration that leaves more
    /// than this fraction of the error.
    double slow = 0.1;
    /// Compliance of each point for the stability test, in the same unit.
    double       stability_compliance = 1e-4;
    unsigned int max_rounds = 30; ///< Maximum number of proximal iterations.
    /// Proximal iterations end after this number without a smaller error.
    unsigned int idle = 2;
    /// Proximal iterations end if the error of one of them exceeds this value.
    double         failed = 1e-6;
    InterfaceRules interface; ///< Rules of each proximal iteration.
  };

  /// Solves @p problem by proximal iterations of solve_interface(), starting
  /// from the forces @p start, such as those of the previous load step. If it
  /// does not converge, the best solution is returned with its error.
  InterfaceSolution
  solve_coulomb(const CoulombProblem &problem,
                const PointVectors   &start,
                const CoulombRules   &rules = {});
} // namespace lamella

#endif
