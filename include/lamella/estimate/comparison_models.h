// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_comparison_models_h
#define lamella_estimate_comparison_models_h

#include <lamella/run/simulation.h>
#include <lamella/scene/scene.h>

#include <functional>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace lamella
{
  /// A solved comparison model for error estimation.
  struct Model
  {
    Scene                 scene;   ///< Scene from which the model was built.
    ResultNumbers         numbers; ///< Results of the last load step.
    std::vector<BodySize> sizes;   ///< Numbers of DoFs etc. of each body.
  };

  /// Cache of solved models, found by their scene; none is solved twice.
  class ModelCache
  {
  public:
    /// Returns the stored model of @p scene; null if there is none.
    const Model *
    find(const Scene &scene) const;
    /// Stores a copy of @p model.
    void
    keep(const Model &model);

  private:
    std::map<std::string, Model> models;
  };

  /// Solves coarser and finer models of a run's scene to compare results.
  class ComparisonModels
  {
  public:
    /// Keeps references to all arguments, which must outlive this object.
    /// solved() prints a line per model to @p out.
    ComparisonModels(const Simulation &run,
                     std::ostream     &out,
                     ModelCache       &cache);

    /// Returns the solved model of @p scene, from the cache if it was solved
    /// before. Otherwise it is solved and printed as @p what. If the callback
    /// @p look is given, the model is always solved, and @p look is called with
    /// its simulation. Throws as Simulation. Collective.
    Model
    solved(const Scene                                   &scene,
           const std::string                             &what,
           const std::function<void(const Simulation &)> &look = {});

  private:
    const Simulation &run;
    std::ostream     &out;
    ModelCache       &cache;
  };

  /// Returns a string that identifies the model of @p scene: the text of all
  /// entries as read (Scene::resolved), and with all digits the members that
  /// may have changed since: theory, axis segments, axis, refinement and
  /// stabilization of bodies, divisions of sections, and contact laws. Models
  /// with equal strings have equal results at the last load factor. Without a
  /// member of these structures, this function does not compile.
  std::string
  key_of(const Scene &scene);
} // namespace lamella

#endif
