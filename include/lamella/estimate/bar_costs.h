// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_bar_costs_h
#define lamella_estimate_bar_costs_h

#include <lamella/adapt/plan.h>
#include <lamella/run/simulation.h>
#include <lamella/scene/scene.h>

#include <vector>

namespace lamella
{
  /// Returns a lower bound of the number of multiplications for the Cholesky
  /// factorizations of @p run, the sum of z^2 / n for factors with n columns
  /// and z nonzeros. Returns 0 if there are none (`cg`, strategy `full`).
  double
  operations(const Simulation &run);

  /// Returns the estimated number of multiplications for error bars by finer
  /// models (Estimation), in which SV-10 replaces Lagrange expansions LE-N. It
  /// is the sum of
  /// - factorization: c m^3 per axis node with m section functions, c =
  ///   CostRules::of_block, and CostRules::axes times the nodes of the run;
  /// - proper orthogonal decomposition of the responses to harmonic loads;
  /// - solutions on short end segments for the boundary-layer modes.
  ///
  /// Returns infinity unless SV-10 can replace LE-N in all bodies.
  double
  operations_of_bars(const Simulation &run,
                     const PlanRules  &rules = {},
                     const CostRules  &cost  = {});

  /// Returns the estimated number of multiplications of two models on axes
  /// halved @p times, for bodies of @p sizes: @p rich, of LE-N, and one degree
  /// less.
  double
  operations_of_coarser_axes(const Scene                 &rich,
                             const std::vector<BodySize> &sizes,
                             const unsigned int           times);
} // namespace lamella

#endif
