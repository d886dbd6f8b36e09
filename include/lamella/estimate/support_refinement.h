// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_support_refinement_h
#define lamella_estimate_support_refinement_h

#include <lamella/estimate/comparison_models.h>

#include <iosfwd>
#include <vector>

namespace lamella
{
  /// Parameters of support_refinement_changes().
  struct SupportRefinementRules
  {
    /// Elements at a support are bisected if longer than this multiple of the
    /// larger section side: too long to resolve the disturbance at the support.
    double longest = 0.5;
    /// Number of bisections of such an element at the support.
    unsigned int times = 2;
  };

  /// Returns the changes of the goals of @p run by short elements at supports:
  /// at points and lines that supports constrain within a beam, and at
  /// constrained ends of heated beams. Two models of LE-1 are compared, on the
  /// axes of @p run and on these axes bisected at the supports; LE-1 has three
  /// quarters of the local effect of higher degrees.
  ///
  /// The result is J(bisected) - J(LE-1) for each goal, signed. It is empty if
  /// there are no such supports, if their elements are short, with
  /// node-dependent theories, or if a contact pairs nodes. Prints a line per
  /// model to @p out; @p cache stores the models. Throws as Simulation does.
  /// Collective.
  std::vector<double>
  support_refinement_changes(const Simulation             &run,
                             std::ostream                 &out,
                             ModelCache                   &cache,
                             const SupportRefinementRules &rules = {});
} // namespace lamella

#endif
