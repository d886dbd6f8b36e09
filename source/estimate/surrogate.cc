// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/estimate/run_goals.h>
#include <lamella/estimate/surrogate.h>

#include <cmath>

namespace lamella
{
  std::vector<double>
  surrogate_error(const Simulation &run,
                  const Scene      &next,
                  std::ostream     &out,
                  ModelCache       &cache)
  {
    Scene scene    = for_estimates(run);
    bool  replaces = false;
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      {
        Theory       &theory = scene.bodies[b].theory;
        const Theory &other  = next.bodies[b].theory;
        if (theory.is_layerwise() && other.has_responses())
          {
            theory   = theory.to_saint_venant(other.order);
            replaces = true;
          }
      }
    if (!replaces)
      return {};
    ComparisonModels    models(run, out, cache);
    const ResultNumbers own =
      models.solved(scene, "own fields of the sections").numbers;
    const RunGoals      goals(run);
    std::vector<double> lost;
    for (const NamedQuantity &quantity : goals.quantities())
      lost.push_back(
        std::abs(goals.numbers().value(quantity) - own.value(quantity)));
    return lost;
  }
} // namespace lamella
