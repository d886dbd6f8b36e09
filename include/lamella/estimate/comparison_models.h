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
  /// Scene, numbers and body sizes of a solved model.
  struct Model
  {
    Scene                 scene;
    ResultNumbers         numbers;
    std::vector<BodySize> sizes;
  };

  /// Solved models of one scene by key_of(), so that none is solved twice.
  class ModelCache
  {
  public:
    /// Returns the model of @p scene, or null.
    const Model *
    find(const Scene &scene) const;
    void
    keep(const Model &model);

  private:
    std::map<std::string, Model> models;
  };

  /// Solver of further models of the scene of a run, one after the other.
  class ComparisonModels
  {
  public:
    /// Prints a line per model to @p out.
    ComparisonModels(const Simulation &run,
                     std::ostream     &out,
                     ModelCache       &cache);

    /// Returns the model of @p scene; solves it, with the line @p what, unless
    /// it is known or @p look is given, which gets the solved simulation.
    /// Throws what Simulation throws. Collective.
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
