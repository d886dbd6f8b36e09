// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_comparison_models_h
#define lamella_estimate_comparison_models_h

#include <lamella/estimate/enrichment.h>
#include <lamella/recover/results.h>
#include <lamella/run/simulation.h>
#include <lamella/scene/scene.h>

#include <functional>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace lamella
{
  /// A solved model for error estimation: its scene, results and body sizes.
  struct Model
  {
    Scene                 scene;
    ResultNumbers         numbers;
    std::vector<BodySize> sizes;
  };

  /// Solved models of one scene by key_of(), so that no model is solved twice.
  class ModelCache
  {
  public:
    /// Returns the stored model of @p scene, or null.
    const Model *
    find(const Scene &scene) const;
    void
    keep(const Model &model);

  private:
    std::map<std::string, Model> models;
  };

  /// Solves coarser and finer models of a run's scene for comparison with it.
  class ComparisonModels
  {
  public:
    /// Keeps references to all arguments. Prints a line per model to @p out.
    ComparisonModels(const Simulation &run,
                     std::ostream     &out,
                     ModelCache       &cache);

    /// Returns the solved model of @p scene, from the cache if it was solved
    /// before. Otherwise solves it and prints the line @p what. If @p look is
    /// given, the model is always solved, and @p look called with the
    /// simulation. Throws what Simulation throws. Collective.
    Model
    solved(const Scene                                   &scene,
           const std::string                             &what,
           const std::function<void(const Simulation &)> &look = {});

  private:
    const Simulation &run;
    std::ostream     &out;
    ModelCache       &cache;
  };
} // namespace lamella

#endif
