// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_support_refinement_h
#define lamella_estimate_support_refinement_h

#include <lamella/estimate/comparison_models.h>

#include <iosfwd>
#include <vector>

namespace lamella
{
  /// Constants of support_refinement_changes().
  struct SupportRefinementRules
  {
    /// Element length over the larger section side above which an element
    /// spreads the disturbance at a support over its own length.
    double longest = 0.5;
    /// Number of bisections of such an element, at the place.
    unsigned int times = 2;
  };

  /**
   * Returns the changes of the goals of @p run by short elements at supported
   * places: at points and lines that supports constrain within a beam, and at
   * constrained ends of heated beams. Both models are LE-1, on the axes of @p
   * run and on these bisected at the places; LE-1 has three quarters of the
   * local effect of higher degrees.
   *
   * The result is J(bisected) - J(LE-1) for each goal, signed. It is empty if
   * there are no such places, if their elements are short already, with
   * node-dependent theories, or if a contact pairs nodes. Prints a line per
   * model to @p out; @p cache keeps the models. Throws what Simulation throws.
   * Collective.
   */
  std::vector<double>
  support_refinement_changes(const Simulation             &run,
                             std::ostream                 &out,
                             ModelCache                   &cache,
                             const SupportRefinementRules &rules = {});
} // namespace lamella

#endif
