// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_comparison_h
#define lamella_estimate_comparison_h

#include <lamella/estimate/comparison_models.h>
#include <lamella/estimate/error_bar.h>
#include <lamella/estimate/local_errors.h>
#include <lamella/estimate/surpluses.h>
#include <lamella/run/simulation.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// A model with which a run is compared.
  struct ComparisonModel
  {
    std::string what;  ///< Difference to the run, for the user.
    Scene       scene; ///< Scene from which the model is built.
    /// True if Localization by this finer model gives errors of elements.
    bool is_for_elements = false;
  };

  /// Values of a goal (output quantity) from which its bar is computed.
  struct ComparedValues
  {
    double run      = 0.; ///< Value in the run.
    double scale    = 0.; ///< Reference of relative errors (RunGoals).
    double rounding = 0.; ///< Rounding error of the value in the run.
    /// Value in each model of the recipe; empty if surpluses replace them.
    std::vector<double> models;
    /// Hierarchical surpluses of the goal, if the recipe has them.
    std::optional<SurplusParts> surplus;
  };

  /// Rule by which error bars are made: the models with which the run is
  /// compared, and the formula of the bar. Comparison solves the models.
  struct Recipe
  {
    /// Reason why the run cannot have such bars, for the user; empty if it can.
    std::string                  unavailable;
    std::string                  from;   ///< Name of the models, for the user.
    std::vector<ComparisonModel> models; ///< Models to be solved.
    /// Model in which changes by contact penalties and substeps are computed.
    std::optional<std::size_t> of_contact;
    /// True if goals with a derivative have surpluses, which replace the models
    /// without contacts.
    bool has_surpluses = false;
    /// Returns the bar of a goal, with its parts by error source.
    std::function<ErrorBar(const ComparedValues &)> bar;
  };

  /// Bars from coarser models, for beams of LE-N, N >= 3. J_0 is the goal in
  /// the run, J_1 on half of the elements with one degree less, and J_2 on a
  /// quarter with two degrees less. The last change is
  ///   d = max(|s_section| + |s_axis|, |J_0 - J_1|)
  /// with the changes s by section and axis from Surpluses (zero if unknown).
  /// This formula with J_1 - J_2 gives the previous change e. The bar is
  /// coarser_model_bar() of d and e, with an error of at least |J_1 - J_2| / 8.
  /// Without contacts, goals with a derivative have bars from surpluses alone.
  Recipe
  coarser_model_recipe(const Simulation &run, const EstimateRules &rules = {});

  /// Bars from models that differ in one error source each, for bodies of SV-N
  /// (section functions computed for N wave numbers), perhaps beside LE-N. Runs
  /// to a tolerance use the finer models in parentheses:
  /// - axis: half of the elements (twice as many);
  /// - fields: three wave numbers less (four more);
  /// - section: one order or degree less (one more if the order is below
  ///   EstimateRules::min_order, otherwise also one less).
  /// All models have the same boundary-layer modes. The bar is the sum of
  /// |change| times factors: EstimateRules::safety, of_axis for half of the
  /// elements. The error estimate is the sum of the changes to finer models.
  Recipe
  single_source_recipe(const Simulation &run, const EstimateRules &rules = {});

  /// Choice of the comparison models of halved_axis_recipe().
  struct HalvedAxisPlan
  {
    /// Number of times that the number of axis elements is halved.
    unsigned int times = 1;
    /// Degree of LE that replaces other theories; 0 if sections are unchanged.
    unsigned int degree = 2;
  };

  /// Bars of runs for which there are no coarser models of the same theory:
  /// LE-1 and LE-2 (Lagrange expansions), EBBT, TBT, TE-N and SV. The models
  /// have half or a quarter of the axis elements (HalvedAxisPlan) and
  /// - H_p: the run's theories and degrees;
  /// - H_r: LE with one degree more; LE of the degree of @p plan replaces other
  ///   theories;
  /// - H_l: one degree less than H_p if all bodies are LE, else than H_r.
  ///
  /// The error estimate of a goal J is s = J(H_r) - J(H_p), and the bar is
  ///   2 |s| + |J(run) - J(H_p)|.
  /// It is at least |J(H_p) - J(H_l)| / 8 if all bodies are LE, and at least
  /// |J(H_r) - J(H_l)| otherwise. If there is no finer section (degree 0), as
  /// for large rotations, the bar is 2 |J(run) - J(H_p)|.
  Recipe
  halved_axis_recipe(const Simulation     &run,
                     const HalvedAxisPlan &plan  = {},
                     const EstimateRules  &rules = {});

  /// Returns the most accurate models of halved_axis_recipe() of at most @p
  /// most multiplications, if any. LE-1 replaces only EBBT, TBT and TE-1.
  std::optional<HalvedAxisPlan>
  affordable_plan(const Simulation &run, const double most);

  /// Returns the first available of coarser_model_recipe(),
  /// single_source_recipe() and halved_axis_recipe(); with large rotations the
  /// last, without a finer section. Otherwise Recipe::unavailable is not empty.
  Recipe
  choose_recipe(const Simulation &run, const EstimateRules &rules = {});

  /// Returns two models for the effect of short axis elements at supports: LE-1
  /// (bilinear Lagrange expansion) on the axes of @p run, and on axes with long
  /// elements at supports bisected: at points and lines that supports constrain
  /// within a beam, and at constrained ends. LE-1 has 3/4 of the change in
  /// higher degrees. None if there are no such supports or only
  /// short elements, with node-dependent theories, or if a contact pairs nodes.
  std::vector<ComparisonModel>
  models_at_supports(const Simulation &run, const EstimateRules &rules = {});

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
