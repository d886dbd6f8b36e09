// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_support_refinement_h
#define lamella_estimate_support_refinement_h

#include <lamella/estimate/comparison_models.h>

#include <iosfwd>
#include <vector>

namespace lamella
{
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
