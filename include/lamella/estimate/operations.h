// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_operations_h
#define lamella_estimate_operations_h

#include <lamella/adapt/plan_rules.h>
#include <lamella/run/simulation.h>

namespace lamella
{
  /// Returns a lower bound of the number of multiplications for the Cholesky
  /// factorizations of @p run, the sum of z^2 / n for factors with n columns
  /// and z nonzeros. Returns 0 if there are none (`cg`, strategy `full`).
  double
  operations(const Simulation &run);

  /// Returns the estimated number of multiplications for the factorizations of
  /// the finer models of Estimation, in which SV-10 (section functions for 10
  /// wave numbers) replaces Lagrange expansions LE-N:
  /// - factorization: CostRules::of_block m^3 per axis node, with m section
  ///   functions (PlanRules::fields_of_responses) and CostRules::axes times as
  ///   many nodes as the run has;
  /// - products and eigenvectors (POD) of 2 functions per wave number and load;
  /// - solutions of end segments for boundary-layer modes (nodes_of_pieces()).
  ///
  /// Returns infinity unless SV-10 can replace LE-N in all bodies.
  double
  operations_of_bars(const Simulation &run,
                     const PlanRules  &rules = {},
                     const CostRules  &cost  = {});
} // namespace lamella

#endif
