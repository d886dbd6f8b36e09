// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_contact_shares_h
#define lamella_estimate_contact_shares_h

#include <lamella/estimate/goal_dual.h>
#include <lamella/estimate/other_models.h>
#include <lamella/run/simulation.h>

#include <memory>
#include <optional>
#include <vector>

namespace lamella
{
  /// How bars take what contact changes, by what was measured
  /// (doc/friction.md).
  struct ContactShareRules
  {
    /// Of the change by exact contact: nothing is left then, and twice for what
    /// a poorer model is asked.
    double of_penalties = 2.;
    /// Of the change by twice as many substeps. As much again is left of an
    /// error of first order, 3.4 times as much of one of order 1/2, as where
    /// contact grows.
    double of_path = 4.;
    /// The same of the estimate: of first order.
    double left_of_path = 2.;
  };

  /**
   * What contact changes of a run's goals beside what the mesh does to it.
   *
   * Penalties: the state of the last step is found again with exact rows in
   * their place, on the stiffness that the run has factorised, and a goal
   * changes by
   *   J'_u . (u_exact - u) + J'_lambda . (lambda_exact - lambda).
   * Rows open and close as they have to. Of a goal without a derivative it is
   * what exact contact changes in a poorer model (compare()). Nothing changes
   * where no contact has a penalty.
   *
   * Load steps, where a contact has friction: what twice as many substeps
   * change in a poorer model. The law is integrated by backward Euler in the
   * slip, of first order at most.
   *
   * Refers to the run. Throws NumericsError where the exact problem has no
   * answer. Collective.
   */
  class ContactShares
  {
  public:
    explicit ContactShares(const Simulation &run);

    /// Solves @p poorer, whose numbers are @p numbers, without penetration and
    /// in twice as many substeps by means of @p others, as far as @p goals want
    /// it.
    void
    compare(const std::vector<NamedQuantity> &goals,
            OtherModels                      &others,
            const Scene                      &poorer,
            const ResultNumbers              &numbers);

    /// Adds to @p result, that of @p goal, one of those that were compared,
    /// what there is, as ContactShareRules say: to the estimate as it is
    /// signed, and to bar and shares.
    void
    add_to(const NamedQuantity &goal, GoalResult &result) const;

  private:
    /// exact - run.
    double
    of_penalties(const NamedQuantity &goal) const;

    ContactShareRules rules;
    bool              any_penalty, any_friction;
    /// exact - run of the last state; without friction.
    BlockVector         u;
    std::vector<double> force;
    /// Of all rows that are active in either state.
    std::unique_ptr<const GoalDual> dual;
    /// Of the poorer model: as it is, without penetration, in twice as many
    /// substeps.
    std::optional<ResultNumbers> poor, exact, shorter;
  };
} // namespace lamella

#endif
