// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_contact_shares_h
#define lamella_estimate_contact_shares_h

#include <lamella/estimate/comparison_models.h>
#include <lamella/estimate/goal_dual.h>
#include <lamella/estimate/rules.h>
#include <lamella/run/simulation.h>

#include <memory>
#include <optional>
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
} // namespace lamella

#endif
