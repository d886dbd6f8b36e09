// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_condensed_strategy_h
#define lamella_solve_condensed_strategy_h

#include <lamella/linear/dense_cholesky.h>
#include <lamella/solve/compliance.h>
#include <lamella/solve/contact_problem.h>

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
  class CondensedStrategy
  {
  public:
    /// @p structure, which has its solvers, and the rows are referred to.
    CondensedStrategy(const Structure &structure, const GapRows &rows);

    /**
     * The linear system of one iteration. With B_A the rows @p active and d in
     * place of 1/eps,
     *   K du - B_A^T dlambda = r_u,
     *   B_A du + d dlambda   = r_lambda.
     * @p r_lambda and @p dlambda have an entry for each active row. @p r_u need
     * not be condensed. du vanishes in what supports prescribe.
     */
    void
    solve(const std::vector<unsigned int> &active,
          const BlockVector               &r_u,
          const Vector                    &r_lambda,
          BlockVector                     &du,
          Vector                          &dlambda);

    /**
     * Solves @p problem, which is convex and has one solution,
     *   K du = B^T (lambda - lambda_state),  g = g_state + B du,
     *   lambda = max(0, ((d - a) lambda_bar - g) / d):
     * the law g + a lambda >= 0 with its softness a raised to a d that the
     * arithmetic bears, about an estimate lambda_bar of the forces. Finds which
     * rows are active.
     */
    ContactSolution
    settle(const ContactProblem &problem, const Monitor &monitor);

    StrategyMemory
    memory() const;

    void
    recall(const StrategyMemory &memory);

    /// The largest estimate of a condition number met so far, 0 if unknown.
    double
    condition_estimate() const;

    NumericalSoftness numerical_softness;

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

    const Structure &structure;
    const GapRows    rows;
    Compliance       compliance;
    /// C + d of the rows that were active in the last linear solve, and d.
    std::optional<DenseCholesky> factor;
    std::vector<unsigned int>    factorised_for;
    std::vector<double>          factorised_with;
  };
} // namespace lamella

#endif
