// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_comparison_h
#define lamella_estimate_comparison_h

#include <lamella/estimate/comparison_models.h>
#include <lamella/estimate/error_bar.h>
#include <lamella/estimate/local_errors.h>
#include <lamella/estimate/recipes.h>
#include <lamella/run/simulation.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Contributions of contact penalties and load steps to the errors of the
  /// goals (quantities of interest) of a run.
  ///
  /// Penalties: the last equilibrium state (displacements u, contact forces
  /// lambda) is solved again with exact contact, on the factorized stiffness of
  /// the run and with its own active set. A goal J changes by
  ///   J'_u . (u_exact - u) + J'_lambda . (lambda_exact - lambda).
  /// If the goal has no derivative, or with friction, the change is computed in
  /// a coarser model (compare()). It is zero without penalties.
  ///
  /// Load steps, with friction only (integrated by backward Euler, of first
  /// order at most): the change by twice as many substeps in a coarser model.
  /// Throws NumericsError if exact contact fails. Collective.
  class ContactShares
  {
  public:
    /// Solves the last state of @p run with exact contact, if there are
    /// penalties and no friction. Keeps a reference to @p run.
    explicit ContactShares(const Simulation    &run,
                           const EstimateRules &rules = {});

    /// Solves the coarser model @p poorer, which has the results @p numbers,
    /// with exact contact and with twice as many substeps, if @p goals need it.
    void
    compare(const std::vector<NamedQuantity> &goals,
            ComparisonModels                 &others,
            const Scene                      &poorer,
            const ResultNumbers              &numbers);

    /// Returns false if @p goal is a mode that a coarser model lacks.
    bool
    has(const NamedQuantity &goal) const
    {
      return (!exact || exact->has(goal)) && (!shorter || shorter->has(goal));
    }

    /// Adds the changes of @p goal, one of the goals of compare(), times the
    /// factors in EstimateRules to @p result: the signed changes to the
    /// error estimate, their absolute values to the bar.
    void
    add_to(const NamedQuantity &goal, GoalResult &result) const;

  private:
    /// Returns the change of @p goal if exact contact replaces penalties.
    double
    of_penalties(const NamedQuantity &goal) const;

    EstimateRules rules;
    bool          any_penalty, any_friction;
    /// Changes of the last state to exact contact; empty with friction.
    BlockVector         u;
    std::vector<double> force;
    /// Derivatives of goals with all constraints active in either state.
    std::unique_ptr<const GoalDual> dual;
    /// Results of the coarser model: as given, exact contact, more substeps.
    std::optional<ResultNumbers> poor, exact, shorter;
  };

  /// Comparison of a run with the models of a recipe, for error bars of its
  /// goals (output quantities). Each model has its own contact constraints and
  /// active set, so active-set errors are included. Models that supports need
  /// (models_at_supports()) raise bars; ContactShares adds penalties and load
  /// steps.
  class Comparison
  {
  public:
    /// Solves the models of @p recipe, whose run is @p run; its last load step
    /// must have been solved. Prints a line per model to @p out; @p cache
    /// stores the models. Throws as Simulation does. Collective.
    Comparison(const Simulation    &run,
               const Recipe        &recipe,
               std::ostream        &out,
               ModelCache          &cache,
               const EstimateRules &rules = {});

    /// Returns the goals of the scene with their error bars.
    std::vector<GoalResult>
    goals() const;

  private:
    /// Returns true if the goal with index @p number requires the models.
    bool
    needs_models(const unsigned int number) const;
    void
    solve_models(std::ostream &out, ModelCache &cache);
    /// Solves models_at_supports(). If they fail, @p out gets a message.
    void
    solve_at_supports(std::ostream &out, ModelCache &cache);
    std::optional<SurplusParts>
    surplus_of(const unsigned int number) const;
    ComparedValues
    values_of(const unsigned int number) const;

    const Simulation &run;
    EstimateRules     rules;
    Recipe            recipe;
    RunGoals          of_run;
    GoalDual          dual;
    ContactShares     of_contact;
    /// Derivative of each goal; empty if it has none, or without surpluses.
    std::vector<std::optional<GoalDual::Pair>> derivatives;
    /// Hierarchical surpluses of the run; null if it has none.
    std::unique_ptr<const Surpluses> surpluses;
    /// Results of the models of the recipe; empty if not solved.
    std::vector<ResultNumbers> results;
    /// Results of models_at_supports(), if any.
    std::vector<ResultNumbers> at_supports;
    /// Error of each goal per axis element; empty if unknown.
    std::vector<std::optional<LocalErrors>> local;
  };

  /// Goals of a run with their error bars, or the reason why there are none.
  struct GoalBars
  {
    std::vector<GoalResult> goals; ///< Empty if there are no error bars.
    std::string             missing_reason; ///< Sentence; empty if bars exist.
    std::string             recipe; ///< Recipe::from; empty for Estimation.
  };

  /// Returns the goals of @p run, whose last load step must have been solved,
  /// with the error bars that the input file requests (ErrorBars), at any cost
  /// for goals with tolerances: by the recipe of choose_recipe(), or for
  /// `richer`, or if there is none or its models fail, by Estimation. Prints a
  /// line per model to @p out; @p cache stores the models. Collective.
  GoalBars
  error_bars_of(const Simulation    &run,
                std::ostream        &out,
                ModelCache          &cache,
                const EstimateRules &rules = {});
} // namespace lamella

#endif
