// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_goal_bars_h
#define lamella_estimate_goal_bars_h

#include <lamella/estimate/comparison_models.h>
#include <lamella/run/simulation.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace lamella
{
  /// Goals of a run with their error bars, or the reason why there are none.
  struct GoalBars
  {
    std::vector<GoalResult> goals; ///< Empty if there are no error bars.
    std::string             missing_reason; ///< Sentence; empty if bars exist.
  };

  /// Returns the goals of @p run, whose last load step must have been solved,
  /// with the error bars that the input file requests (ErrorBars), at any cost
  /// for goals with tolerances. The first available of CoarserModelEstimate,
  /// EnrichmentEstimate and HalvedAxisEstimate is used; if none is, or for
  /// `richer`, Estimation. Bars of the first three are at least twice
  /// support_refinement_changes(), the change by refinement at supports. Prints
  /// a line per model to @p out; @p cache stores the models. Collective.
  GoalBars
  error_bars_of(const Simulation &run, std::ostream &out, ModelCache &cache);

  /// Parameters of the local mesh refinement at supports.
  struct SupportRefinementRules
  {
    /// Largest length of an axis element at a support, as a multiple of the
    /// larger section side. Longer ones miss the local disturbance.
    double       longest = 0.5;
    unsigned int times   = 2; ///< Number of bisections of longer elements.
  };

  /// Returns the signed change of each goal of @p run if long axis elements at
  /// supports are bisected: at points and lines that supports constrain within
  /// a beam, and at constrained ends of heated beams. Two models of LE-1
  /// (bilinear Lagrange expansion) are compared, on the axes of @p run and on
  /// the bisected axes. LE-1 has 3/4 of the change in higher degrees.
  ///
  /// The result, bisected minus other model, is empty if there are no such
  /// supports or only short elements, with node-dependent theories, or if a
  /// contact pairs nodes. Prints to @p out; @p cache stores the models. Throws
  /// as Simulation does. Collective.
  std::vector<double>
  support_refinement_changes(const Simulation             &run,
                             std::ostream                 &out,
                             ModelCache                   &cache,
                             const SupportRefinementRules &rules = {});
} // namespace lamella

#endif
