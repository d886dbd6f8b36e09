// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_operations_h
#define lamella_estimate_operations_h

#include <lamella/adapt/plan_rules.h>
#include <lamella/run/simulation.h>

namespace lamella
{
  /// What @p run spent on its factors, in multiplications: of a factor with n
  /// columns and z non-zeros at least z^2 / n, the sum of the squares of its
  /// columns where these are alike. 0 where no factor was made (`cg`, the
  /// strategy `full`).
  double
  operations(const Simulation &run);

  /**
   * What its richer models (Estimation) would take, as far as it can be counted
   * before they are built (CostRules): of_block m^3 for each node of an axis,
   * m = fields_of_responses, and the nodes of `axes` where SV-10 stands in for
   * LE-N; the products and eigenvectors of the responses, two for each wave
   * number and each load vector of what touches the body; and the pieces
   * that its end fields take, as a share of the run's factor
   * (nodes_of_pieces()). Infinite where
   * it does not for some body: a richer model of the same kind always costs
   * more than the run.
   */
  double
  operations_of_bars(const Simulation &run,
                     const PlanRules  &rules = {},
                     const CostRules  &cost  = {});
} // namespace lamella

#endif
