// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_large_step_h
#define lamella_solve_large_step_h

#include <lamella/solve/load_path.h>

namespace lamella
{
  /// Load step with finite rotations: Newton's method with moving contacts,
  /// then checks of the equilibrium. A step that does not converge is bisected.
  class LargeStep : public Step
  {
  public:
    /// Keeps references to all arguments except @p n_supports, the number of
    /// supports. @p progress receives a line of text per iteration.
    LargeStep(const Structure                    &structure,
              const MovingContacts               &contacts,
              const unsigned int                  n_supports,
              const SolveParameters              &parameters,
              const NonlinearSolver::Progress    &progress,
              const TangentOperator::BodyMonitor &monitor,
              dealii::TimerOutput                &timer);

    SolvedStep
    operator()(const State      &before,
               const LoadFactor &from,
               const LoadFactor &to,
               const bool        last = true) override;

    Checks
    check(const State      &state,
          const LoadFactor &factor,
          const bool        last = true) override;

    void
    resume_from(const State &last, const LoadFactor &factor) override;

  private:
    /// Returns the equilibrium at which the load step to @p to starts: @p
    /// before at load factor @p from, or the unloaded state if it is empty.
    Equilibrium
    make_start(const State      &before,
               const LoadFactor &from,
               const LoadFactor &to);

    const Structure &structure;
    NonlinearSolver  solver;
    /// Displacements at which the contact constraints were last updated.
    BlockVector            reached;
    const unsigned int     n_supports;
    const SolveParameters &parameters;
    dealii::TimerOutput   &timer;
  };
} // namespace lamella

#endif
