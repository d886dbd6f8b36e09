// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_contact_strategy_h
#define lamella_solve_contact_strategy_h

#include <lamella/base/names.h>
#include <lamella/solve/contact_problem.h>
#include <lamella/solve/tangent_operator.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Solution method for contact (entry `Contact strategy`). Both methods give
  /// the same results if the solution is unique, e.g. without friction.
  enum class Strategy
  {
    undefined,
    automatic, ///< the one with fewer operations, see choose_strategy()
    condensed, ///< Factorization of K per body: CondensedStrategy.
    full       ///< K + penalties of the whole scene: FullStrategy.
  };

  /// Names of the contact strategies in parameter files.
  template <>
  struct Names<Strategy>
  {
    /// Value and name of each contact strategy.
    static constexpr NameOf<Strategy> all[] = {{Strategy::automatic, "auto"},
                                               {Strategy::condensed,
                                                "condensed"},
                                               {Strategy::full, "full"}};
  };

  /// Base class of the contact solvers for a constant tangent stiffness: finds
  /// the active set, and solves linear systems with a given active set.
  /// LinearSystem refines the result. Collective, with equal arguments.
  class ContactStrategy
  {
  public:
    /// Keeps references to both arguments, which must outlive this object.
    ContactStrategy(const TangentOperator &tangent_operator,
                    const GapConstraints  &rows)
      : tangent_operator(tangent_operator)
      , rows(rows)
    {}
    ContactStrategy(const ContactStrategy &) = delete;
    ContactStrategy &
    operator=(const ContactStrategy &) = delete;
    virtual ~ContactStrategy();

    /// Finds the active set and the increment of @p problem from its state,
    ///   K du = r + B^T (lambda - lambda_state),  g = g_state + B du,
    ///   lambda = max(0, ((d - a) lambda_bar - g) / d),
    /// with gaps g, constraint rows B, contact forces lambda and the residual
    /// r of the state. This is the
    /// contact law with the compliance d instead of a, without effect if the
    /// estimate lambda_bar is lambda (NumericalCompliance). The solution is
    /// unique without friction. @p monitor is called after each round; its
    /// exceptions end the search. Throws NumericsError if a system cannot be
    /// solved.
    virtual ContactSolution
    solve(const ContactProblem &problem, const Monitor &monitor) = 0;

    /// Solves the linear system of one correction,
    ///   K du - C dlambda   = r_u,
    ///   R du + d dlambda   = r_lambda,
    /// with the rows R of the gaps and slips @p closed, the columns C of their
    /// forces (C = R^T without friction) and the numerical compliance d. @p
    /// r_lambda (lengths) and @p dlambda (forces) have one entry per item of
    /// ActiveConstraints::numbers; @p r_u (forces) need not be condensed. du is
    /// zero in prescribed DoFs. The factorization is reused in the next call.
    /// Throws NumericsError if the system is indefinite or singular.
    virtual void
    solve(const ActiveConstraints &closed,
          const BlockVector       &r_u,
          const Vector            &r_lambda,
          BlockVector             &du,
          Vector                  &dlambda) = 0;

    /// Returns the data of this strategy that a restarted run needs.
    virtual StrategyHistory
    memory() const = 0;
    /// Restores the result of memory() in a new strategy. Collective.
    virtual void
    restore(const StrategyHistory &memory) = 0;

    /// Increases the numerical penalty tenfold, which accelerates the
    /// convergence of the estimated contact forces (NumericalCompliance).
    void
    increase_penalty()
    {
      numerical_compliance.increase_penalty();
    }

    /// Returns true if the contact forces of solve() are accurate before
    /// refinement; false for FullStrategy, where penalties cost digits.
    virtual bool
    forces_are_accurate() const = 0;

    /// Returns advice for the message if contact does not converge, a phrase.
    virtual std::string
    remedy() const = 0;

    /// Returns warnings about penalties and rounding, one sentence each.
    virtual std::vector<std::string>
    warnings() const
    {
      return {};
    }

  protected:
    const TangentOperator &tangent_operator;     ///< Tangent stiffness.
    const GapConstraints   rows;                 ///< All contact constraints.
    NumericalCompliance    numerical_compliance; ///< Current penalty.
  };

  /// Returns @p which, or for `automatic` the strategy with fewer operations:
  /// `full` if n^3 / 3 for @p n gaps and slips with friction in contact, those
  /// of a factor of their compliance, exceed N b^2 summed over all bodies with
  /// N DoFs and b stiffness entries per DoF, and 1e9.
  Strategy
  choose_strategy(const Strategy   which,
                  const Structure &structure,
                  const double     n);

  /// Returns the choice for the @p rows that are closed at the start.
  Strategy
  choose_strategy(const Strategy        which,
                  const Structure      &structure,
                  const GapConstraints &rows);

  /// Returns the strategy `condensed`. Keeps references to @p tangent_operator,
  /// which must have factorizations, and to @p rows.
  std::unique_ptr<ContactStrategy>
  make_condensed_strategy(const TangentOperator &tangent_operator,
                          const GapConstraints  &rows);

  /// Returns a strategy of the kind @p which for the constraints @p rows. The
  /// stiffness @p tangent_operator must have factorizations for `condensed`.
  std::unique_ptr<ContactStrategy>
  make_strategy(const Strategy         which,
                const TangentOperator &tangent_operator,
                const GapConstraints  &rows);
} // namespace lamella

#endif
