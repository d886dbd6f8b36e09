// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_start_h
#define lamella_estimate_start_h

#include <lamella/adapt/plan_rules.h>
#include <lamella/run/simulation.h>

namespace lamella
{
  /**
   * What a run to a tolerance begins with where @p scene does not say its
   * Theory: what plan() makes of SV-6. Why it makes something else of a body is
   * added to @p why, a sentence without a full stop each, if it is not null.
   * Nothing is solved; rows are made of the bodies with the fields of TE-1.
   * Throws what building a scene throws.
   */
  Scene
  start_of(Scene                     scene,
           std::vector<std::string> *why   = nullptr,
           const PlanRules          &rules = {});

  /// @p scene, out of which @p model was made, with LE-3 (first_degree) for the
  /// bodies of SV-N that keep all fields of their section
  /// (PlanRules::most_fields): these are compact. Whether any changed.
  bool
  begin_with_layers(Scene            &scene,
                    const BuiltScene &model,
                    const PlanRules  &rules = {});

  /// @p scene with LE-3 (first_degree) for bodies of a lower degree.
  Scene
  with_levels_below(Scene scene, const PlanRules &rules = {});
} // namespace lamella

#endif
