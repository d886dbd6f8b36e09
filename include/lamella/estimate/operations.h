// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_operations_h
#define lamella_estimate_operations_h

#include <lamella/adapt/plan_rules.h>
#include <lamella/run/simulation.h>

namespace lamella
{
  /// Returns the number of multiplications of @p run for factorizations: at
  /// least z^2 / n for a factor with n columns and z nonzeros. 0 if there are
  /// no factorizations (`cg`, strategy `full`).
  double
  operations(const Simulation &run);

  /// Returns the estimated number of multiplications for the finer models of
  /// Estimation, in which SV-10 replaces LE-N, in the run's factorizations:
  /// - of_block m^3 (CostRules) per axis node with m fields
  ///   (PlanRules::fields_of_responses), for `axes` times the nodes of the run;
  /// - products and eigenvectors of 2 functions per wave number and load;
  /// - end segments for boundary-layer modes (nodes_of_pieces()).
  ///
  /// Infinite unless SV-10 can replace LE-N in all bodies.
  double
  operations_of_bars(const Simulation &run,
                     const PlanRules  &rules = {},
                     const CostRules  &cost  = {});
} // namespace lamella

#endif
