// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/estimate/comparison_models.h>
#include <lamella/estimate/model_key.h>

#include <ostream>

namespace lamella
{
  const Model *
  ModelCache::find(const Scene &scene) const
  {
    const auto place = models.find(key_of(scene));
    return place == models.end() ? nullptr : &place->second;
  }



  void
  ModelCache::keep(const Model &model)
  {
    models[key_of(model.scene)] = model;
  }



  ComparisonModels::ComparisonModels(const Simulation &run,
                                     std::ostream     &out,
                                     ModelCache       &cache)
    : run(run)
    , out(out)
    , cache(cache)
  {}



  Model
  ComparisonModels::solved(const Scene                                   &scene,
                           const std::string                             &what,
                           const std::function<void(const Simulation &)> &look)
  {
    if (const Model *known = cache.find(scene); known != nullptr && !look)
      return *known;
    std::ostream nowhere(nullptr);
    out << "  " << what << ": " << std::flush;
    // `Rotations = auto` is decided for the run itself only.
    Scene compared                    = scene;
    compared.solve.computes_estimates = false;
    Simulation     simulation(compared, nowhere, run.model().rules());
    const Results &results = simulation.solve();
    Model          model{simulation.model().scene(),
                ResultNumbers(results),
                sizes_of(simulation.model())};
    out << results.n_dofs() << " DoFs, "
        << to_text(results.seconds.at("total"), 2) << " s" << std::endl;
    cache.keep(model);
    if (look)
      look(simulation);
    return model;
  }
} // namespace lamella
