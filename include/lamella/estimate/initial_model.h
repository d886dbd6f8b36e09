// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_initial_model_h
#define lamella_estimate_initial_model_h

#include <lamella/adapt/plan.h>
#include <lamella/run/simulation.h>

namespace lamella
{
  /// Returns the scene of the first model of a run to a tolerance. If the input
  /// file does not set the Theory and there are contacts, plan() chooses SV-6
  /// (section functions for 6 wave numbers) or, with a sentence in @p why if
  /// not null, another theory for each body. Contacts are found with a model of
  /// TE-1, which is not solved. Throws the exceptions of BuiltScene.
  Scene
  initial_model(Scene                     scene,
                std::vector<std::string> *why   = nullptr,
                const PlanRules          &rules = {});

  /// Replaces SV-N by LE-3 (PlanRules::first_degree) in @p scene, from which @p
  /// model was built, for each body with SV-N by default that has all section
  /// functions at all nodes. Returns true if there is such a body.
  bool
  start_with_layerwise(Scene            &scene,
                       const BuiltScene &model,
                       const PlanRules  &rules = {});

  /// Returns @p scene with LE of degree PlanRules::first_degree (3) or more.
  Scene
  with_min_degree(Scene scene, const PlanRules &rules = {});
} // namespace lamella

#endif
