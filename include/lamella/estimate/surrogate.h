// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_surrogate_h
#define lamella_estimate_surrogate_h

#include <lamella/estimate/comparison_models.h>

#include <iosfwd>
#include <vector>

namespace lamella
{
  /// Returns the error of each goal J if SV-N (section functions for N wave
  /// numbers) replaces Lagrange expansions LE: |J(LE) - J(SV-N)| on the
  /// sections and axes of @p run, for the bodies that are LE in @p run and SV-N
  /// in @p next. Returns no errors if there are none. A comparison with other
  /// wave numbers would not detect some errors, such as of the slowly decaying
  /// warping of thin walls near a twisting load. Prints a line to @p out; @p
  /// cache stores the model. Throws the exceptions of Simulation. Collective.
  std::vector<double>
  surrogate_error(const Simulation &run,
                  const Scene      &next,
                  std::ostream     &out,
                  ModelCache       &cache);
} // namespace lamella

#endif
