// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_contact_strategy_h
#define lamella_solve_contact_strategy_h

#include <lamella/base/names.h>
#include <lamella/solve/contact_problem.h>
#include <lamella/solve/linearisation.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// How contact is solved for (`Contact strategy`). Both come to the same
  /// results, where these are unique: with much friction they need not be.
  enum class Strategy
  {
    undefined,
    condensed, ///< K factorised once, contact on its compliance:
               ///< CondensedStrategy
    full       ///< K + K^p of the whole scene, as in the paper: FullStrategy
  };

  template <>
  struct Names<Strategy>
  {
    static constexpr NameOf<Strategy> all[] = {{Strategy::condensed,
                                                "condensed"},
                                               {Strategy::full, "full"}};
  };

  /**
   * What contact is solved with about one state of a structure, that of its
   * Linearisation: it settles which rows are active for a tangent that does
   * not change, and solves linear systems with rows that are. It refines
   * nothing and knows no residual of the state: ContactSolver does that, the
   * same for all strategies.
   *
   * Refers to the linearisation and, through a view, to the rows: both must
   * outlive it. Where processes share the work, all of them call all functions
   * with the same arguments.
   */
  class ContactStrategy
  {
  public:
    ContactStrategy(const Linearisation &linearisation, const GapRows &rows)
      : linearisation(linearisation)
      , rows(rows)
    {}
    ContactStrategy(const ContactStrategy &) = delete;
    ContactStrategy &
    operator=(const ContactStrategy &) = delete;
    virtual ~ContactStrategy();

    /**
     * Solves @p problem, which without friction has one solution,
     *   K du = B^T (lambda - lambda_state),  g = g_state + B du,
     *   lambda = max(0, ((d - a) lambda_bar - g) / d):
     * the law g + a lambda >= 0 with its softness a raised to a d that the
     * arithmetic bears, about an estimate lambda_bar of the forces (which a
     * strategy may better as it goes). Finds which rows are active. @p monitor
     * is told of every round. Without rows that penetrate, forces or estimates
     * to begin with, the answer is no change, and the monitor is not called.
     * Throws what the monitor throws, and NumericsError where the arithmetic
     * does not hold the problem.
     */
    virtual ContactSolution
    settle(const ContactProblem &problem, const Monitor &monitor) = 0;

    /**
     * Solves the linear system of one correction: with R the rows of the gaps
     * and slips that are @p closed, C^T their forces (B_A both without
     * friction) and d the numerical softness of a row, at least a,
     *   K du - C dlambda   = r_u,
     *   R du + d dlambda   = r_lambda,
     * which is the paper's Eq. 22 when dlambda is eliminated. @p r_lambda
     * (lengths) and @p dlambda (forces) have an entry for each number of
     * @p closed.
     * @p r_u (forces) need not be condensed. du vanishes in what supports
     * prescribe. What was factorised is kept for the next call with the same
     * rows and softness. Throws NumericsError if the system is not positive
     * definite; of rows that slide, if it is singular.
     */
    virtual void
    solve(const ClosedRows  &closed,
          const BlockVector &r_u,
          const Vector      &r_lambda,
          BlockVector       &du,
          Vector            &dlambda) = 0;

    /// What was learnt so far, as it is kept for a resumed run.
    virtual StrategyMemory
    memory() const = 0;
    /// Back again, into a strategy of the same scene that has solved nothing
    /// yet. Collective.
    virtual void
    recall(const StrategyMemory &memory) = 0;

    /// Makes estimates of forces converge faster, where that is still possible
    /// (NumericalSoftness::stiffen()).
    void
    stiffen()
    {
      numerical_softness.stiffen();
    }

    /// Whether the forces that it settles are as exact as the compliance of
    /// rows, so that a state may be made of them alone: not where they come of
    /// K + K^p, in which penalties drown digits.
    virtual bool
    forces_stand_alone() const = 0;

    /// What to try where the search does not end, besides a finer mesh and more
    /// iterations: the middle of a sentence.
    virtual std::string
    remedy() const = 0;

    /// What the user should know of penalties and arithmetic, a sentence each.
    virtual std::vector<std::string>
    warnings() const
    {
      return {};
    }

  protected:
    const Linearisation &linearisation;
    const GapRows        rows;
    NumericalSoftness    numerical_softness;
  };

  /// The strategy @p which about the state of @p linearisation, which must have
  /// solvers for `condensed` and needs none for `full`.
  std::unique_ptr<ContactStrategy>
  make_strategy(const Strategy       which,
                const Linearisation &linearisation,
                const GapRows       &rows);
} // namespace lamella

#endif
