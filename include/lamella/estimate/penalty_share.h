// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_penalty_share_h
#define lamella_estimate_penalty_share_h

#include <lamella/estimate/goal_dual.h>
#include <lamella/estimate/other_models.h>
#include <lamella/run/simulation.h>

#include <memory>
#include <optional>
#include <vector>

namespace lamella
{
  /**
   * What the penalties of a run's contacts change of its goals: the state of
   * the last step is found again with exact rows in their place, on the
   * stiffness that the run has factorised, and a goal changes by
   *   J'_u . (u_exact - u) + J'_lambda . (lambda_exact - lambda).
   * Rows open and close as they have to. Of a goal without a derivative it is
   * what exact contact changes in a poorer model (compare()). Nothing changes
   * where no contact has a penalty. Refers to the run. Throws NumericsError
   * where the exact problem has no answer. Collective.
   */
  class PenaltyShare
  {
  public:
    explicit PenaltyShare(const Simulation &run);

    /// Whether some contact has a penalty.
    bool
    is_any() const
    {
      return dual != nullptr;
    }

    /// Solves @p poorer, whose numbers are @p numbers, without penetration by
    /// means of @p others, if one of @p goals wants it.
    void
    compare(const std::vector<NamedQuantity> &goals,
            OtherModels                      &others,
            const Scene                      &poorer,
            const ResultNumbers              &numbers);

    /// Of @p goal, one of those that were compared.
    double
    of(const NamedQuantity &goal) const;

  private:
    /// exact - run.
    BlockVector         u;
    std::vector<double> force;
    /// Of all rows that are active in either state.
    std::unique_ptr<const GoalDual> dual;
    /// Of the poorer model, with its penalties and without.
    std::optional<ResultNumbers> soft, exact;
  };
} // namespace lamella

#endif
