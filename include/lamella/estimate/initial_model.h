// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_initial_model_h
#define lamella_estimate_initial_model_h

#include <lamella/adapt/plan_rules.h>
#include <lamella/run/simulation.h>

namespace lamella
{
  /// Returns the scene of the first model of a run to a tolerance if the input
  /// file does not set its Theory: plan() applied to SV-6 (section functions
  /// for 6 wave numbers). If @p why is not null, a sentence is added for each
  /// body whose theory is not SV-6. Nothing is solved; contact is paired with
  /// TE-1. Throws the exceptions of BuiltScene.
  Scene
  initial_model(Scene                     scene,
                std::vector<std::string> *why   = nullptr,
                const PlanRules          &rules = {});

  /// Sets LE-3 (PlanRules::first_degree) in @p scene, from which @p model was
  /// built, for each compact body of SV-N that has all section functions at all
  /// nodes (PlanRules::max_fields_share). Returns true if there is such a body.
  bool
  start_with_layerwise(Scene            &scene,
                       const BuiltScene &model,
                       const PlanRules  &rules = {});

  /// Returns @p scene with LE of degree PlanRules::first_degree (3) or more.
  Scene
  with_min_degree(Scene scene, const PlanRules &rules = {});
} // namespace lamella

#endif
