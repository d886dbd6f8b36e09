// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_other_models_h
#define lamella_estimate_other_models_h

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
  /// A model that was solved: its scene, its numbers, and how large its bodies
  /// are.
  struct Model
  {
    Scene                 scene;
    ResultNumbers         numbers;
    std::vector<BodySize> sizes;
  };

  /// Models of one scene that were solved, by key_of() theirs: one that is
  /// asked for again is known.
  class ModelCache
  {
  public:
    /// That of @p scene, or null.
    const Model *
    find(const Scene &scene) const;
    void
    keep(const Model &model);

  private:
    std::map<std::string, Model> models;
  };

  /// Models of the scene of a run beside it, solved one after the other. The
  /// run, the stream and the cache are referred to.
  class OtherModels
  {
  public:
    /// @p out is told of each model, a line each.
    OtherModels(const Simulation &run, std::ostream &out, ModelCache &cache);

    /// Solves @p scene and tells @p what it is, unless it is known. What solved
    /// it is handed to @p look before it goes; then it is solved in any case.
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
