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
  /// Estimation, in which SV-10 replaces LE-N (CostRules): of_block m^3 per
  /// axis node with m = PlanRules::fields_of_responses, for `axes` times the
  /// nodes; products and eigenvectors of section functions, two per wave number
  /// and load vector; and the end segments for boundary-layer modes, over the
  /// run's factorization (nodes_of_pieces()). Infinite if not for all.
  double
  operations_of_bars(const Simulation &run,
                     const PlanRules  &rules = {},
                     const CostRules  &cost  = {});
} // namespace lamella

#endif
