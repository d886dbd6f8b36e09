// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_full_strategy_h
#define lamella_solve_full_strategy_h

#include <lamella/solve/contact_strategy.h>
#include <lamella/solve/penalty_matrix.h>

namespace lamella
{
  /// Newton's method on the displacements u and contact forces lambda of the
  /// whole scene. A constraint with gap g and compliance a of its contact law
  /// is active if
  ///   lambda - (g(u) + a lambda) / d > 0
  /// (semi-smooth Newton or primal-dual active set method; for penalties, d =
  /// a, and the condition is g < 0). The Newton step is
  ///   (K + K^p) du = r_u + B_A^T r_lambda / d,   K^p = B_A^T diag(1/d) B_A,
  ///   dlambda      = (r_lambda - B_A du) / d
  /// with the tangent stiffness K, gradients B_A of active gaps, numerical
  /// compliance d, unbalanced forces r_u, and r_lambda = -(g(u) + a lambda).
  /// Each iteration factorizes the matrix of the whole scene (PenaltyMatrix).
  /// Globalization: tensile constraints are deactivated. Those with the deepest
  /// penetration are activated, at most eight or as many as are active. If an
  /// active set occurs again, the step is shortened to the point of lowest
  /// energy. FrictionNewton solves problems with friction.
  class FullStrategy : public ContactStrategy
  {
  public:
    /// Assembles the stiffness of @p tangent_operator, which needs no linear
    /// solvers, for the contact constraints @p rows.
    FullStrategy(const TangentOperator &tangent_operator,
                 const GapConstraints  &rows);

    ContactSolution
    solve(const ContactProblem &problem, const Monitor &monitor) override;

    /// Solves one linear Newton system with the active constraints @p closed,
    /// for unbalanced forces @p r_u and gap residuals @p r_lambda.
    void
    solve(const ActiveConstraints &closed,
          const BlockVector       &r_u,
          const Vector            &r_lambda,
          BlockVector             &du,
          Vector                  &dlambda) override;

    /// Returns the penalty factor, and the constraints in the matrix pattern.
    StrategyHistory
    memory() const override;
    void
    restore(const StrategyHistory &memory) override;

    bool
    forces_are_accurate() const override
    {
      return false;
    }

    std::string
    remedy() const override
    {
      return rows.has_friction() ? "the condensed strategy" :
                                   "a softer penalty, the condensed strategy";
    }

    /// Returns a warning if a large penalty causes rounding errors.
    std::vector<std::string>
    warnings() const override
    {
      return matrix.warnings();
    }

  private:
    /// Solves a contact problem with friction (FrictionNewton).
    ContactSolution
    solve_with_friction(const ContactProblem &problem, const Monitor &monitor);
    /// Iterate of Newton's method, relative to the state of the problem.
    struct Iterate
    {
      /// Displacement increment du, and its internal forces K du.
      BlockVector du, K_du;
      /// Contact force of each constraint, positive in compression.
      std::vector<double> force;
      /// Indices of the active constraints, ascending.
      std::vector<unsigned int> active;
    };

    /// Returns the first iterate: no displacement increment, estimated contact
    /// forces and active constraints of @p problem.
    Iterate
    begin(const ContactProblem &problem) const;
    /// Performs the Newton step with the active constraints of @p at. Others
    /// get no force. Returns the largest change of a displacement [length].
    double
    step(const ContactProblem &problem, Iterate &at);
    /// Returns d lambda - (g + a lambda) of each constraint [length]; it is to
    /// be active if this is positive. For penalties, it is the penetration -g.
    std::vector<double>
    overlaps(const ContactProblem &problem, const Iterate &at) const;
    /// Returns true if constraint @p row is active and not tensile in @p at.
    static bool
    stays_active(const Iterate &at, const unsigned int row);
    /// Returns the tensile active constraints, and the inactive ones whose
    /// overlaps() exceed @p closed [length].
    static Round
    violating_rows(const Iterate             &at,
                   const std::vector<double> &overlap,
                   const double               closed);
    /// Returns the next active set: active constraints without tension, and up
    /// to max(8, number of active) with the largest overlaps() > @p closed.
    static std::vector<unsigned int>
    next_active_set(const Iterate             &at,
                    const std::vector<double> &overlap,
                    const double               closed);
    /// Returns the iterate at the fraction @p t from @p from to @p to.
    Iterate
    interpolate_iterate(const ContactProblem &problem,
                        const Iterate        &from,
                        const Iterate        &to,
                        const double          t) const;
    /// Returns the minimum of the convex energy along the step from @p from to
    /// @p to. Bisection ends when the work of the unbalanced forces along the
    /// step is at most 1 % of its value at @p from. Used to prevent cycles, if
    /// the active set of @p to occurred before.
    Iterate
    energy_minimum(const ContactProblem &problem,
                   const Iterate        &from,
                   const Iterate        &to) const;

    PenaltyMatrix matrix;
  };
} // namespace lamella

#endif
