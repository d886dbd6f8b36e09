// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_multiplier_loop_h
#define lamella_solve_multiplier_loop_h

#include <lamella/solve/condensed_strategy.h>
#include <lamella/solve/contact_solver.h>

namespace lamella
{
  /**
   * The strategy `condensed`: the method of multipliers (augmented Lagrangian)
   * around the condensed complementarity problem, in which the forces so far
   * are the estimate lambda_bar of the next ones,
   *   lambda = max(0, ((d - a) lambda_bar - g) / d).
   * Bodies are linear, so only the active set is not; CondensedStrategy finds
   * it. What it found is refined against the strain-first residual and the
   * contact law itself, and looked at again: rows that pull or penetrate after
   * that send it back with better estimates of state and forces. Rows without
   * penetration (`exact`, `augmented lagrangian`) come out of the same loop:
   * each refinement and each return takes the forces so far as the estimate (a
   * proximal point iteration).
   *
   * It ends when no active row pulls, no other penetrates by more than 1e-14 of
   * the displacements (or the last correction, where digits are lost), and the
   * gaps of active rows keep the law to 1e-12 of the displacements; to 1e-10
   * where another round hardly betters them. Where a round leaves more than a
   * tenth of the last one's error, the penalties of estimates are raised.
   */
  class MultiplierLoop : public ContactSolver
  {
  public:
    /// @p linearisation must have solvers; its structure and the rows must
    /// outlive this.
    MultiplierLoop(std::shared_ptr<const Linearisation> linearisation,
                   const GapRows                       &rows,
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
    /// What is wrong with a refined state: how it breaks the contact law.
    struct Misses
    {
      /// Active rows that pull, and others that penetrate.
      std::vector<unsigned int> opening, closing;
      /// The largest |g + a lambda| of the others that are active, a length.
      double gap = 0.;
    };

    /// Of @p state with the gaps @p g; a gap above -@p closed is none that
    /// penetrates.
    Misses
    misses(const State               &state,
           const std::vector<double> &g,
           const double               closed) const;

    /// The problem that is to be solved first: about the state without contact
    /// forces, with the forces of @p previous as the estimate in those of its
    /// active rows that penetrate in @p free_gaps.
    ContactProblem
    first_problem(const std::vector<double> &free_gaps,
                  const State               &previous) const;

    /**
     * Takes rows of the refined @p state that pull out of the active set and
     * rows that penetrate into it, refines, and looks again; whether that ended
     * well (in 20 rounds at most). It is for rows that hardly touch, where the
     * rounding of the compliance decides and gives the same wrong set again and
     * again.
     */
    bool
    correct_set(State &state, const double factor);

    CondensedStrategy strategy;
  };
} // namespace lamella

#endif
