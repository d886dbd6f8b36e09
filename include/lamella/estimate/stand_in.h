// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_stand_in_h
#define lamella_estimate_stand_in_h

#include <lamella/estimate/other_models.h>

#include <iosfwd>
#include <vector>

namespace lamella
{
  /**
   * What goals lose where the section's own fields stand in for all of them:
   * of each goal of @p run the size of J(all fields) - J(own fields), both on
   * the sections and axes of @p run. The bodies are those that are LE there and
   * SV-N in @p next; empty if there are none. Poorer and richer models of SV-N
   * do not tell it: what no wave number finds (the slow warping of thin walls
   * beside a load that twists them, say) all of them are without. The
   * run is referred to, @p out told of the model, which @p cache keeps. Throws
   * what Simulation throws. Collective.
   */
  std::vector<double>
  lost_by_stand_ins(const Simulation &run,
                    const Scene      &next,
                    std::ostream     &out,
                    ModelCache       &cache);
} // namespace lamella

#endif
