// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_full_strategy_h
#define lamella_solve_full_strategy_h

#include <lamella/solve/contact_strategy.h>
#include <lamella/solve/penalty_matrix.h>

namespace lamella
{
  /**
   * Newton's method of the paper on the displacements and contact forces of the
   * whole scene. At (u, lambda) a row is active if
   *   lambda - (g(u) + a lambda) / d > 0
   * (semi-smooth Newton or primal-dual active set method; g < 0 for penalties,
   * where d = a), and the step is
   *   (K + K^p) du = r_u + B_A^T r_lambda / d,   K^p = B_A^T diag(1/d) B_A,
   *   dlambda      = (r_lambda - B_A du) / d
   * (Eqs. 22 and 23) with the residuals r_u and r_lambda = -(g(u) + a lambda)
   * at the state. (Eq. 22 is in total form; residuals at the state count the
   * gaps once, whatever Eqs. 25 and 26 add on the right.) Each round factorizes
   * the whole scene (PenaltyMatrix) and uses the previous forces as estimates.
   *
   * Globalization: tensile rows are deactivated; of the penetrating ones the
   * worst are activated, at most eight or as many as are active. If an active
   * set returns, the step is cut at the lowest energy along it. FrictionNewton
   * replaces this with friction.
   */
  class FullStrategy : public ContactStrategy
  {
  public:
    /// Assembles K of @p linearization, which needs no solvers.
    FullStrategy(const TangentOperator &tangent_operator,
                 const GapConstraints  &rows);

    ContactSolution
    solve(const ContactProblem &problem, const Monitor &monitor) override;

    /// Solves one system with K + K^p of the active rows.
    void
    solve(const ActiveConstraints &closed,
          const BlockVector       &r_u,
          const Vector            &r_lambda,
          BlockVector             &du,
          Vector                  &dlambda) override;

    /// Returns the increase of the penalty, and the rows in the matrix pattern.
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

    /// Returns a warning if the penalties are too hard for doubles
    /// (PenaltyMatrix::warnings()).
    std::vector<std::string>
    warnings() const override
    {
      return matrix.warnings();
    }

  private:
    /// An iterate, relative to the state of the problem.
    struct Iterate
    {
      /// Displacement increment, and K du from strains, as penalties cost
      /// digits of the matrix.
      BlockVector du, K_du;
      /// Force of each row.
      std::vector<double> force;
      /// Active rows, ascending.
      std::vector<unsigned int> active;
    };

    /// Returns the forces and active rows that @p problem starts from, with
    /// zero displacement.
    Iterate
    begin(const ContactProblem &problem) const;
    /// Performs the Newton step on the active rows of @p at; the forces of
    /// other rows become zero. Returns the largest change of a displacement.
    double
    step(const ContactProblem &problem, Iterate &at);
    /// Returns d lambda - (g + a lambda) of each row [length]: d times the
    /// force of its law if positive, or the penetration -g for penalties, where
    /// d = a.
    std::vector<double>
    overlaps(const ContactProblem &problem, const Iterate &at) const;
    /// Returns true if @p row is active and not tensile.
    static bool
    stays_active(const Iterate &at, const unsigned int row);
    /// Returns the tensile active rows, and the inactive rows that overlap by
    /// more than @p closed.
    static Round
    violating_rows(const Iterate             &at,
                   const std::vector<double> &overlap,
                   const double               closed);
    /// Returns the next active set, ascending: the rows that stay, and the
    /// worst of those that overlap by more than @p closed, at most eight or as
    /// many as are active.
    static std::vector<unsigned int>
    next_active_set(const Iterate             &at,
                    const std::vector<double> &overlap,
                    const double               closed);
    /// Returns the point at the fraction @p t from @p from to @p to, with the
    /// forces of the law there.
    Iterate
    interpolate_iterate(const ContactProblem &problem,
                        const Iterate        &from,
                        const Iterate        &to,
                        const double          t) const;
    /// Returns the minimum of the convex energy between @p from and @p to,
    /// whose active set was there before: the point where the forces do no more
    /// work, by bisection to a hundredth of the initial work. The energy falls,
    /// so no set returns forever.
    Iterate
    energy_minimum(const ContactProblem &problem,
                   const Iterate        &from,
                   const Iterate        &to) const;

    PenaltyMatrix matrix;
  };
} // namespace lamella

#endif
