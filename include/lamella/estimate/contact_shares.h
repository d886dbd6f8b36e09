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
  /// Measured factors from a change by contact to a bar
  /// (doc/theory/friction.md).
  struct ContactShareRules
  {
    /// Factor of the change by exact contact, perhaps of a poorer model.
    double of_penalties = 2.;
    /// Factor of the change by twice as many substeps: the error left is once
    /// the change at first order, and 3.4 times at order 1/2 (growing contact).
    double of_path = 4.;
    /// Factor of that change in the estimate: first order.
    double left_of_path = 2.;
  };

  /**
   * Effects of penalties and load steps on a run's goals.
   *
   * Penalties: the last state is solved again with exact rows, on the run's
   * factorized stiffness and with an active set of its own. A goal changes by
   *   J'_u . (u_exact - u) + J'_lambda . (lambda_exact - lambda).
   * For a goal without a derivative, and with friction, it is the change by
   * exact contact in a poorer model (compare()). Zero without penalties.
   *
   * Load steps, with friction: the change by twice as many substeps in a poorer
   * model. The law is integrated by backward Euler in the slip, of first order
   * at most. Throws NumericsError without an exact solution. Collective.
   */
  class ContactShares
  {
  public:
    explicit ContactShares(const Simulation &run);

    /// Solves @p poorer, whose numbers are @p numbers, without penetration and
    /// in twice as many substeps, by @p others, as far as @p goals need it.
    void
    compare(const std::vector<NamedQuantity> &goals,
            ComparisonModels                 &others,
            const Scene                      &poorer,
            const ResultNumbers              &numbers);

    /// Adds the effects to @p result of @p goal, one of compare(), by
    /// ContactShareRules: signed to the estimate, by size to bar and shares.
    void
    add_to(const NamedQuantity &goal, GoalResult &result) const;

  private:
    /// Returns the change exact - run.
    double
    of_penalties(const NamedQuantity &goal) const;

    ContactShareRules rules;
    bool              any_penalty, any_friction;
    /// Change exact - run of the last state; empty with friction.
    BlockVector         u;
    std::vector<double> force;
    /// Dual of all rows that are active in either state.
    std::unique_ptr<const GoalDual> dual;
    /// Numbers of the poorer model, without penetration, and in more substeps.
    std::optional<ResultNumbers> poor, exact, shorter;
  };
} // namespace lamella

#endif
