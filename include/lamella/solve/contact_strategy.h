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
  /// Solution method for contact (`Contact strategy`). Both give the same
  /// results where these are unique, as without much friction.
  enum class Strategy
  {
    undefined,
    condensed, ///< K factorized once, contact on its compliance:
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

  /// Contact solver about one state of a structure, that of its
  /// TangentOperator: finds the active set for a constant tangent, and solves
  /// linear systems with a given active set. ContactSolver refines against the
  /// residual. Refers to the tangent operator and views the rows. Collective,
  /// with the same arguments on all processes.
  class ContactStrategy
  {
  public:
    ContactStrategy(const TangentOperator &tangent_operator,
                    const GapConstraints  &rows)
      : tangent_operator(tangent_operator)
      , rows(rows)
    {}
    ContactStrategy(const ContactStrategy &) = delete;
    ContactStrategy &
    operator=(const ContactStrategy &) = delete;
    virtual ~ContactStrategy();

    /**
     * Solves @p problem,
     *   K du = B^T (lambda - lambda_state),  g = g_state + B du,
     *   lambda = max(0, ((d - a) lambda_bar - g) / d),
     * and returns the active set. This is the law g + a lambda >= 0 with its
     * compliance a raised to the numerical d, about an estimate lambda_bar of
     * the forces. The solution is unique without friction. @p monitor is called
     * after each round, its exceptions pass. The increment is zero without
     * penetration, forces and estimates. Throws NumericsError for unsolvable
     * systems.
     */
    virtual ContactSolution
    solve(const ContactProblem &problem, const Monitor &monitor) = 0;

    /**
     * Solves the linear system of one correction,
     *   K du - C dlambda   = r_u,
     *   R du + d dlambda   = r_lambda,
     * with the rows R of the gaps and slips @p closed, their force columns C
     * (C^T = R = B_A without friction) and the numerical compliance d >= a.
     * This is Eq. 22 once dlambda is eliminated. @p r_lambda (lengths) and @p
     * dlambda (forces) have one entry per number of @p closed; @p r_u (forces)
     * need not be condensed. du is zero in prescribed DoFs. The factor is kept
     * for the next call. Throws NumericsError if the system is not positive
     * definite or, with slipping constraints, singular.
     */
    virtual void
    solve(const ActiveConstraints &closed,
          const BlockVector       &r_u,
          const Vector            &r_lambda,
          BlockVector             &du,
          Vector                  &dlambda) = 0;

    /// Returns the data that a resumed run needs.
    virtual StrategyHistory
    memory() const = 0;
    /// Restores @p memory in a new strategy of the same scene. Collective.
    virtual void
    restore(const StrategyHistory &memory) = 0;

    /// Accelerates the multiplier estimates (NumericalCompliance).
    void
    increase_penalty()
    {
      numerical_compliance.increase_penalty();
    }

    /// Returns true if forces of solve() are as accurate as the compliance.
    /// False with K + K^p, where penalties cost digits.
    virtual bool
    forces_are_accurate() const = 0;

    /// Returns what else to try without convergence, part of a sentence.
    virtual std::string
    remedy() const = 0;

    /// Returns warnings about penalties and rounding, one sentence each.
    virtual std::vector<std::string>
    warnings() const
    {
      return {};
    }

  protected:
    const TangentOperator &tangent_operator;
    const GapConstraints   rows;
    NumericalCompliance    numerical_compliance;
  };

  /// Returns the strategy @p which about the state of @p tangent_operator,
  /// which needs solvers for `condensed`.
  std::unique_ptr<ContactStrategy>
  make_strategy(const Strategy         which,
                const TangentOperator &tangent_operator,
                const GapConstraints  &rows);
} // namespace lamella

#endif
