// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_operations_h
#define lamella_estimate_operations_h

#include <lamella/adapt/plan_rules.h>
#include <lamella/run/simulation.h>

namespace lamella
{
  /// Returns the multiplications of @p run for factorizations: at least z^2 / n
  /// for a factor with n columns and z non-zeros. 0 without factorizations
  /// (`cg`, strategy `full`).
  double
  operations(const Simulation &run);

  /// Returns the estimated multiplications of the richer models of Estimation
  /// (CostRules): of_block m^3 per axis node with m = fields_of_responses, for
  /// `axes` times the nodes, where SV-10 replaces LE-N; products and
  /// eigenvectors of the responses, two per wave number and load vector; and
  /// the pieces for its end fields, as a share of the run's factorization
  /// (nodes_of_pieces()). Infinite if SV-10 replaces LE-N in not every body.
  double
  operations_of_bars(const Simulation &run,
                     const PlanRules  &rules = {},
                     const CostRules  &cost  = {});
} // namespace lamella

#endif
