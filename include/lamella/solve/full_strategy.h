// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_full_strategy_h
#define lamella_solve_full_strategy_h

#include <lamella/solve/contact_strategy.h>
#include <lamella/solve/penalty_matrix.h>

namespace lamella
{
  /// Newton's method on the displacements u and contact forces lambda of the
  /// whole scene. A constraint with gap g and law compliance a is active if
  ///   lambda - (g(u) + a lambda) / d > 0
  /// (semi-smooth Newton or primal-dual active set method; for penalties, where
  /// d = a, this is g < 0), and the step is
  ///   (K + K^p) du = r_u + B_A^T r_lambda / d,   K^p = B_A^T diag(1/d) B_A,
  ///   dlambda      = (r_lambda - B_A du) / d
  /// with the rows B_A of the active constraints, the numerical compliance d
  /// and the residuals r_u of equilibrium and r_lambda = -(g(u) + a lambda).
  /// Each round factorizes the matrix of the whole scene (PenaltyMatrix) and
  /// uses the previous forces as estimates. Globalization: tensile constraints
  /// are deactivated; of the penetrating ones, those with the deepest
  /// penetration are activated, at most eight or as many as are active. If an
  /// active set occurs again, the step ends at the lowest energy along it.
  /// FrictionNewton solves problems with friction.
  class FullStrategy : public ContactStrategy
  {
  public:
    /// Assembles the stiffness of @p tangent_operator, which needs no solvers.
    FullStrategy(const TangentOperator &tangent_operator,
                 const GapConstraints  &rows);

    ContactSolution
    solve(const ContactProblem &problem, const Monitor &monitor) override;

    /// Solves one linear system with K + K^p of the active constraints.
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

    /// Returns a warning if penalties are too hard (PenaltyMatrix::warnings()).
    std::vector<std::string>
    warnings() const override
    {
      return matrix.warnings();
    }

  private:
    /// An iterate of Newton's method, relative to the state of the problem.
    struct Iterate
    {
      /// Displacement increment du, and K du computed from strains.
      BlockVector du, K_du;
      /// Force of each constraint.
      std::vector<double> force;
      /// Active constraints, ascending.
      std::vector<unsigned int> active;
    };

    /// Returns the initial forces and active set, with a zero increment.
    Iterate
    begin(const ContactProblem &problem) const;
    /// Performs the Newton step with the active constraints of @p at; all
    /// others have no force. Returns the largest change of a displacement.
    double
    step(const ContactProblem &problem, Iterate &at);
    /// Returns d lambda - (g + a lambda) of each constraint [length]: d times
    /// its force if positive, or the penetration -g for penalties.
    std::vector<double>
    overlaps(const ContactProblem &problem, const Iterate &at) const;
    /// Returns true if constraint @p row is active and not tensile.
    static bool
    stays_active(const Iterate &at, const unsigned int row);
    /// Returns the tensile active constraints, and the inactive ones whose
    /// overlaps() exceed @p closed [length].
    static Round
    violating_rows(const Iterate             &at,
                   const std::vector<double> &overlap,
                   const double               closed);
    /// Returns the next active set, ascending: active constraints without
    /// tension, and those with the largest overlaps() above @p closed, at most
    /// eight or as many as are active.
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
    /// @p to, by bisection to 1 % of the initial work. Used if the active set
    /// of @p to occurred before, to prevent cycles.
    Iterate
    energy_minimum(const ContactProblem &problem,
                   const Iterate        &from,
                   const Iterate        &to) const;

    PenaltyMatrix matrix;
  };
} // namespace lamella

#endif
