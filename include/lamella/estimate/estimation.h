// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `estimate`: how far a run's numbers are off. It owns the richer
// models that a run is compared with, the bars made of their differences, and
// the loop that goes on until a tolerance is reached. It never solves itself: a
// richer model is a scene like any other, and Simulation solves it.

#ifndef lamella_estimate_estimation_h
#define lamella_estimate_estimation_h

#include <lamella/estimate/enrichment.h>
#include <lamella/recover/named_quantity.h>
#include <lamella/run/simulation.h>

#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace lamella
{
  /// A model that was solved: its scene, its numbers, and what the bodies have
  /// of DoFs.
  struct Model
  {
    Scene                     scene;
    ResultNumbers             numbers;
    std::vector<unsigned int> dofs;
  };

  /// Models of one scene that were solved, by what they differ in (theories,
  /// axes, refinements and enforcements): one that is asked for again is known.
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

  /**
   * The errors of a run's goals, from richer models of the same scene:
   *   M_0          the run
   *   M_1 .. M_k   one source of error less each: axis, fields, section,
   *                contact, whichever the scene has
   *   M_r          axis, fields and section enriched once more.
   * The share of a source is the change of the goal from the model before it,
   * J(M_i) - J(M_(i-1)), so the shares sum to J(M_k) - J(M_0); the bar is that
   * of error_bar() with J(M_k) and J(M_r). Each model is solved whole, with
   * contact rows of its own mesh and its own active set: what a frozen active
   * set cannot see, that it is wrong, this sees, and quantities need not be
   * linear in the displacements.
   *
   * Collective.
   */
  class Estimation
  {
  public:
    /// @p run, whose last step is solved, @p out and @p cache are referred to.
    /// @p out is told of each model, a line each.
    Estimation(const Simulation &run, std::ostream &out, ModelCache &cache);

    /// The goals of the scene with their bars. Where a richer model cannot be
    /// solved, the goals say why there is no bar. Empty without goals, or where
    /// ErrorBars::automatic would cost too much.
    std::vector<GoalResult>
    goals();

  private:
    /// The run as the first model.
    Model
    first_model() const;
    /// Solves @p scene and tells @p what it is.
    Model
    solved(const Scene &scene, const std::string &what);
    /// M_1 .. M_k with the source that each has less of.
    void
    climb();
    /// What the models say of @p quantity.
    GoalResult
    goal(const NamedQuantity &quantity, const unsigned int number) const;
    /// The quantities of the scene, those of whole probes among them.
    std::vector<NamedQuantity>
    quantities() const;
    /// Whether the scene wants bars, and the costs allow it.
    bool
    wanted() const;

    const Simulation   &run;
    std::ostream       &out;
    ModelCache         &cache;
    std::vector<Model>  models;
    std::vector<Source> sources;
    /// Why there is no richer model; empty if there is.
    std::string failure;
  };
} // namespace lamella

#endif
