// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_condensed_strategy_h
#define lamella_solve_condensed_strategy_h

#include <lamella/base/dense_cholesky.h>
#include <lamella/solve/compliance.h>
#include <lamella/solve/contact_strategy.h>

#include <optional>

namespace lamella
{
  /**
   * K is factorised once per body; contact lives on the compliance C of the
   * rows that take part. Each linear solve is then one small dense system,
   * (C + d) dlambda = r_lambda - B K^-1 r_u, and one backward half.
   *
   * The active set is found by row generation: the complementarity problem of
   * the rows that take part is solved exactly (solve_complementarity()), the
   * gaps of all others are looked at, the worst of those that penetrate take
   * part from then on, at most as many as do already. The rows that take part
   * only become more, so this ends. Rows of multipliers that others have closed
   * join last: where rows depend on each other (more points than a surface has
   * freedom to move) they then share the force, as the least sum of squares
   * does.
   */
  class CondensedStrategy : public ContactStrategy
  {
  public:
    /// Both are referred to; @p structure must be factorised.
    CondensedStrategy(const Structure           &structure,
                      const std::vector<GapRow> &rows);

    void
    solve(const std::vector<unsigned int> &active,
          const BlockVector               *r_u,
          const Vector                    &r_lambda,
          BlockVector                     &du,
          Vector                          &dlambda) override;

    ContactSolution
    settle(const ContactProblem &problem, const Monitor &monitor) override;

    StrategyMemory
    memory() const override;

    void
    recall(const StrategyMemory &memory) override;

    double
    condition_estimate() const override;

    std::string
    remedy() const override
    {
      return "a softer penalty";
    }


  private:
    /// The d of a known row: never less than 1e-10 of the compliance, which
    /// keeps C + d definite where rows depend on each other.
    double
    softness(const unsigned int row) const;

    /// Rows with the negative of their gaps, the smallest gap first.
    using Violations = std::vector<std::pair<double, unsigned int>>;

    /// Rows without a softness of their own that touch and are not among
    /// @p part.
    Violations
    touching_rows(const ContactProblem            &problem,
                  const std::vector<unsigned int> &part,
                  const std::vector<double>       &g) const;

    /// Solves @p problem on the rows @p part, beginning with those of them that
    /// are active in @p solution.
    void
    solve_part(const ContactProblem            &problem,
               const std::vector<unsigned int> &part,
               ContactSolution                 &solution);

    /// K^-1 r of the unconstrained DoFs, expanded.
    BlockVector
    apply_inverse(BlockVector r) const;

    Compliance compliance;
    /// C + d of the rows that were active in the last linear solve, and d.
    std::optional<DenseCholesky> factor;
    std::vector<unsigned int>    factorised_for;
    std::vector<double>          factorised_with;
  };
} // namespace lamella

#endif
