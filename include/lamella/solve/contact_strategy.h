// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_contact_strategy_h
#define lamella_solve_contact_strategy_h

#include <lamella/contact/gap_rows.h>
#include <lamella/solve/structure.h>

#include <functional>
#include <string>
#include <vector>

namespace lamella
{
  /// a of the contact law g + a lambda >= 0, lambda >= 0, one of them zero:
  /// 1/eps for `penalty`, zero for the others.
  double
  law_softness(const GapRow &row);

  /// Contact about a state whose displacements and forces are in equilibrium.
  struct ContactProblem
  {
    /// Of each row at that state.
    std::vector<double> gap, force;
    /// What is known of the forces that are sought, lambda_bar.
    std::vector<double> estimate;
    /// Numbers of the rows that are likely to be active.
    std::vector<unsigned int> start;
    /// A gap that is less negative is rounding.
    double closed = 0.;
  };

  struct ContactSolution
  {
    /// To be added to the state's displacements.
    BlockVector du;
    /// Of each row.
    std::vector<double> force;
    /// Numbers of the active rows, ascending.
    std::vector<unsigned int> active;
  };

  /// What there is to tell of one round of ContactStrategy::settle().
  struct Round
  {
    std::size_t active = 0;
    /// Rows whose state was wrong, and by how much the worst of them missed the
    /// law, a length.
    std::vector<unsigned int> changed;
    double                    violation = 0.;
  };

  /// What a strategy has learnt in the load steps so far. Another one of the
  /// same scene that recalls it gives the same numbers to the last bit.
  struct StrategyMemory
  {
    /// Of stiffen().
    double stiffening = 1.;
    /// The rows whose compliance is known, as they became known together.
    std::vector<std::vector<unsigned int>> rows;
  };

  /// Is told of each round; what it throws ends the search.
  using Monitor = std::function<void(const Round &)>;

  /**
   * How contact is solved at a load step. Bodies are linear, so what contact
   * asks for is a convex problem with one solution,
   *   K du = B^T (lambda - lambda_state),  g = g_state + B du,
   *   lambda = max(0, ((d - a) lambda_bar - g) / d):
   * the law g + a lambda >= 0 with its softness a raised to a d that the
   * arithmetic bears, about an estimate lambda_bar of the forces. Repeated with
   * the forces found as the estimate, the law itself comes out (the method of
   * multipliers; a proximal point iteration).
   */
  class ContactStrategy
  {
  public:
    /// Both are referred to.
    ContactStrategy(const Structure           &structure,
                    const std::vector<GapRow> &rows);
    virtual ~ContactStrategy() = default;

    /**
     * The linear system of one iteration. With B_A the rows @p active and d in
     * place of 1/eps,
     *   K du - B_A^T dlambda = r_u,
     *   B_A du + d dlambda   = r_lambda,
     * which is the paper's Eq. 22 when dlambda is eliminated. @p r_lambda and
     * @p dlambda have an entry for each active row. @p r_u need not be
     * condensed; null means zero. du vanishes in what supports prescribe.
     */
    virtual void
    solve(const std::vector<unsigned int> &active,
          const BlockVector               *r_u,
          const Vector                    &r_lambda,
          BlockVector                     &du,
          Vector                          &dlambda) = 0;

    /// Solves @p problem: finds which rows are active.
    virtual ContactSolution
    settle(const ContactProblem &problem, const Monitor &monitor) = 0;

    /// Raises the penalty of rows whose estimate is improved; false once it is
    /// 1000 times what it was.
    bool
    stiffen();

    virtual StrategyMemory
    memory() const
    {
      return {stiffening, {}};
    }

    virtual void
    recall(const StrategyMemory &memory)
    {
      stiffening = memory.stiffening;
    }

    /// The largest estimate of a condition number met so far, 0 if unknown.
    virtual double
    condition_estimate() const = 0;

    /// What to try where the search does not end, besides a finer mesh and more
    /// iterations.
    virtual std::string
    remedy() const = 0;

    /// What the user should know of penalties and arithmetic, a sentence each.
    virtual std::vector<std::string>
    warnings() const
    {
      return {};
    }

  protected:
    /// 1 / (penalty times the stiffening so far).
    double
    numerical_softness(const GapRow &row) const;

    const Structure           &structure;
    const std::vector<GapRow> &rows;

  private:
    double stiffening = 1.;
  };
} // namespace lamella

#endif
