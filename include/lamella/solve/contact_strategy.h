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
  /// Solution method for contact (`Contact strategy`). Both methods give the
  /// same results if these are unique, as for little friction.
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

  /// Base class of the contact solvers for a constant tangent, that of a
  /// TangentOperator: finds the active set, and solves linear systems with a
  /// given active set. ContactSolver refines the result against the residual.
  /// Keeps references to the tangent operator and the constraints. Collective,
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

    /// Solves @p problem,
    ///   K du = B^T (lambda - lambda_state),  g = g_state + B du,
    ///   lambda = max(0, ((d - a) lambda_bar - g) / d),
    /// and returns the solution with its active set. This is the law of
    /// contact, g + a lambda >= 0, with the compliance a increased to the
    /// numerical compliance d, about an estimate lambda_bar of the forces
    /// (NumericalCompliance). The solution is unique without friction.
    /// @p monitor is called after each round; its exceptions end the search.
    /// The increment is zero if penetrations, forces and estimates are zero.
    /// Throws NumericsError if a system cannot be solved.
    virtual ContactSolution
    solve(const ContactProblem &problem, const Monitor &monitor) = 0;

    /// Solves the linear system of one correction,
    ///   K du - C dlambda   = r_u,
    ///   R du + d dlambda   = r_lambda,
    /// with the rows R of the gaps and slips @p closed, the columns C of their
    /// forces (C = R^T without friction) and the numerical compliance d.
    /// @p r_lambda (lengths) and @p dlambda (forces) have one entry per number
    /// of @p closed; @p r_u (forces) need not be condensed. du is zero in
    /// prescribed DoFs. The factorization is reused in the next call. Throws
    /// NumericsError if the system is indefinite or singular.
    virtual void
    solve(const ActiveConstraints &closed,
          const BlockVector       &r_u,
          const Vector            &r_lambda,
          BlockVector             &du,
          Vector                  &dlambda) = 0;

    /// Returns the data that a restarted run needs.
    virtual StrategyHistory
    memory() const = 0;
    /// Restores @p memory in a new strategy of the same scene. Collective.
    virtual void
    restore(const StrategyHistory &memory) = 0;

    /// Increases the numerical penalty, which accelerates the convergence of
    /// the multiplier estimates (NumericalCompliance).
    void
    increase_penalty()
    {
      numerical_compliance.increase_penalty();
    }

    /// Returns true if the forces of solve() are accurate before refinement.
    /// False for FullStrategy, where penalties cost digits.
    virtual bool
    forces_are_accurate() const = 0;

    /// Returns a remedy, part of a sentence, if contact does not converge.
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

  /// Returns a strategy of the kind @p which for the tangent
  /// @p tangent_operator, which must have solvers for `condensed`.
  std::unique_ptr<ContactStrategy>
  make_strategy(const Strategy         which,
                const TangentOperator &tangent_operator,
                const GapConstraints  &rows);
} // namespace lamella

#endif
