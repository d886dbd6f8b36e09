// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_penalty_share_h
#define lamella_estimate_penalty_share_h

#include <lamella/estimate/goal_dual.h>
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
   * Rows open and close as they have to. Refers to the run. Throws
   * NumericsError where the exact problem has no answer. Collective.
   */
  class PenaltyShare
  {
  public:
    explicit PenaltyShare(const Simulation &run);

    /// Of @p goal, if it has a derivative.
    std::optional<double>
    of(const NamedQuantity &goal) const;

  private:
    /// exact - run.
    BlockVector         u;
    std::vector<double> force;
    /// Of all rows that are active in either state.
    std::unique_ptr<const GoalDual> dual;
  };
} // namespace lamella

#endif
