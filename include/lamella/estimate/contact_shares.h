// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_contact_shares_h
#define lamella_estimate_contact_shares_h

#include <lamella/estimate/comparison_models.h>
#include <lamella/estimate/goal_dual.h>
#include <lamella/run/simulation.h>

#include <memory>
#include <optional>
#include <vector>

namespace lamella
{
  /// Measured factors by which the changes of a goal due to penalties and load
  /// steps are multiplied in its error bar (doc/theory/friction.md).
  struct ContactShareRules
  {
    /// Factor for the change by exact contact, possibly from a coarser model.
    double of_penalties = 2.;
    /// Factor for the change by twice as many substeps: the remaining error is
    /// 1 (first order) to 3.4 times it (order 1/2, growing contact).
    double of_path = 4.;
    /// Factor for the change by more substeps in the error estimate.
    double left_of_path = 2.;
  };

  /// Changes of the goals of a run due to penalties and load steps.
  ///
  /// Penalties: the last state (displacements u, contact forces lambda) is
  /// solved again with exact contact, on the factorized stiffness of the run
  /// and with its own active set. A goal J changes by
  ///   J'_u . (u_exact - u) + J'_lambda . (lambda_exact - lambda).
  /// For a goal without a derivative, and with friction, it is the change by
  /// exact contact in a coarser model (compare()). Zero without penalties.
  ///
  /// Load steps, with friction: the change by twice as many substeps in a
  /// coarser model. The friction law is integrated by backward Euler, of first
  /// order at most. Throws NumericsError if exact contact fails. Collective.
  class ContactShares
  {
  public:
    explicit ContactShares(const Simulation &run);

    /// Solves the coarser scene @p poorer, with the results @p numbers, with
    /// exact contact and with twice as many substeps, if @p goals need it.
    void
    compare(const std::vector<NamedQuantity> &goals,
            ComparisonModels                 &others,
            const Scene                      &poorer,
            const ResultNumbers              &numbers);

    /// Adds the changes of @p goal, one of compare(), times ContactShareRules
    /// to @p result: signed to the estimate, by size to bar and shares.
    void
    add_to(const NamedQuantity &goal, GoalResult &result) const;

  private:
    /// Returns the change of @p goal from the run to exact contact.
    double
    of_penalties(const NamedQuantity &goal) const;

    ContactShareRules rules;
    bool              any_penalty, any_friction;
    /// Changes of the last state to exact contact; empty with friction.
    BlockVector         u;
    std::vector<double> force;
    /// Dual solution with all constraints that are active in either state.
    std::unique_ptr<const GoalDual> dual;
    /// Results of the coarser model: as given, exact contact, more substeps.
    std::optional<ResultNumbers> poor, exact, shorter;
  };
} // namespace lamella

#endif
