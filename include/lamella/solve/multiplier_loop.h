// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_multiplier_loop_h
#define lamella_solve_multiplier_loop_h

#include <lamella/solve/condensed_strategy.h>
#include <lamella/solve/contact_solver.h>

namespace lamella
{
  /**
   * The method of multipliers around the condensed complementarity problem.
   * Bodies are linear, so only the active set is not; CondensedStrategy finds
   * it. What it found is refined against the strain-first residual and the
   * contact law itself, and looked at again: rows that pull or penetrate after
   * that send it back with better estimates of state and forces. Rows without
   * penetration (`exact`, `augmented lagrangian`) come out of the same loop:
   * each refinement and each return takes the forces so far as the estimate (a
   * proximal point iteration).
   */
  class MultiplierLoop : public ContactSolver
  {
  public:
    /// @p structure must have its solvers.
    MultiplierLoop(const Structure        &structure,
                   const GapRows          &rows,
                   const SolverParameters &parameters = SolverParameters());

    State
    solve_contact(const State &free,
                  const double factor,
                  const State &previous = State()) override;

    StrategyMemory
    memory() const override
    {
      return strategy.memory();
    }

    void
    recall(const StrategyMemory &memory) override
    {
      strategy.recall(memory);
    }

    double
    condition_estimate() const override
    {
      return strategy.condition_estimate();
    }

    void
    solve_linear(const std::vector<unsigned int> &active,
                 const BlockVector               &r_u,
                 const Vector                    &r_lambda,
                 BlockVector                     &du,
                 Vector                          &dlambda) override
    {
      strategy.solve(active, r_u, r_lambda, du, dlambda);
    }

  protected:
    std::string
    remedy() const override
    {
      return "a softer penalty";
    }

  private:
    /// What is wrong with a refined state.
    struct Misses
    {
      /// Active rows that pull, and others that penetrate.
      std::vector<unsigned int> opening, closing;
      /// The largest |g + a lambda| of the others that are active.
      double gap = 0.;
    };

    Misses
    misses(const State               &state,
           const std::vector<double> &g,
           const double               closed) const;

    /// The problem that is to be solved first.
    ContactProblem
    first_problem(const std::vector<double> &free_gaps,
                  const State               &previous) const;

    /**
     * Takes rows of the refined @p state that pull out of the active set and
     * rows that penetrate into it, refines, and looks again; whether that ended
     * well. It is for rows that hardly touch, where the rounding of the
     * compliance decides and gives the same wrong set again and again.
     */
    bool
    correct_set(State &state, const double factor);

    CondensedStrategy strategy;
  };
} // namespace lamella

#endif
