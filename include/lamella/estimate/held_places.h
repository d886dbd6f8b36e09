// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_held_places_h
#define lamella_estimate_held_places_h

#include <lamella/estimate/other_models.h>

#include <iosfwd>
#include <vector>

namespace lamella
{
  /// What decides whether the elements at a held place are looked at, and how.
  struct HeldPlaceRules
  {
    /// Elements longer than this share of the section's larger side carry what
    /// a support disturbs over a length of their own: coarser axes do not see
    /// it at all, finer ones do.
    double longest = 0.5;
    /// How often such an element is bisected, always the half with the place.
    unsigned int times = 2;
  };

  /**
   * What the goals of @p run change by when the elements at places that
   * supports hold are short: points and lines that they hold within the length
   * of a beam, and ends of beams that are warm. Both models are LE-1, on the
   * axes of @p run and on these bisected at the places: near by, LE-1 does
   * three quarters of what higher degrees do. (A line that a support holds
   * gives way by log(1/h), without limit; a halving of an element is a finite
   * change.)
   *
   * Of each goal J(bisected) - J(LE-1), signed; empty if there are no such
   * places, their elements are short already, or nodes are paired by a contact.
   * The run is referred to, @p out told of the models, which @p cache keeps.
   * Throws what Simulation throws. Collective.
   */
  std::vector<double>
  missed_at_held_places(const Simulation     &run,
                        std::ostream         &out,
                        ModelCache           &cache,
                        const HeldPlaceRules &rules = {});
} // namespace lamella

#endif
