// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_surrogate_h
#define lamella_estimate_surrogate_h

#include <lamella/estimate/comparison_models.h>

#include <iosfwd>
#include <vector>

namespace lamella
{
  /**
   * Returns the errors of goals if the section's own fields (SV-N) replace all
   * fields (LE): |J(all fields) - J(own fields)| for each goal of @p run, on
   * its sections and axes, where the bodies are LE in @p run and SV-N in @p
   * next. Empty if there are none. Comparisons of SV-N with other wave numbers
   * miss, say, the slow warping of thin walls beside a twisting load. Prints a
   * line to @p out; @p cache keeps the model. Throws what Simulation throws.
   * Collective.
   */
  std::vector<double>
  surrogate_error(const Simulation &run,
                  const Scene      &next,
                  std::ostream     &out,
                  ModelCache       &cache);
} // namespace lamella

#endif
