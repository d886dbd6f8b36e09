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
   * at the state. (Eq. 22 is in total form; residuals count the gaps once,
   * whatever Eqs. 25 and 26 add on the right.) Each round factorizes the whole
   * scene (PenaltyMatrix) and uses the previous forces as estimates.
   * Globalization: tensile rows are deactivated; of the penetrating ones the
   * worst are activated, at most eight or as many as are active. If an active
   * set returns, the step is cut at the lowest energy along it. With friction:
   * FrictionNewton.
   */
  class FullStrategy : public ContactStrategy
  {
  public:
    /// Assembles K of @p tangent_operator, which needs no solvers.
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

    /// Returns a warning on too hard penalties (PenaltyMatrix::warnings()).
    std::vector<std::string>
    warnings() const override
    {
      return matrix.warnings();
    }

  private:
    /// An iterate, relative to the state of the problem.
    struct Iterate
    {
      /// Displacement increment, and K du from strains.
      BlockVector du, K_du;
      /// Force of each row.
      std::vector<double> force;
      /// Active rows, ascending.
      std::vector<unsigned int> active;
    };

    /// Returns the forces and active rows to start from, undisplaced.
    Iterate
    begin(const ContactProblem &problem) const;
    /// Performs the Newton step on the active rows of @p at; others have no
    /// force. Returns the largest change of a displacement.
    double
    step(const ContactProblem &problem, Iterate &at);
    /// Returns d lambda - (g + a lambda) of each row [length]: d times the
    /// positive force of its law, or the penetration -g for penalties.
    std::vector<double>
    overlaps(const ContactProblem &problem, const Iterate &at) const;
    /// Returns true if @p row is active and not tensile.
    static bool
    stays_active(const Iterate &at, const unsigned int row);
    /// Returns tensile active rows, and inactive ones overlapping by @p closed.
    static Round
    violating_rows(const Iterate             &at,
                   const std::vector<double> &overlap,
                   const double               closed);
    /// Returns the next active set, ascending: the rows that stay, and the
    /// worst that overlap by more than @p closed, eight or as many as active.
    static std::vector<unsigned int>
    next_active_set(const Iterate             &at,
                    const std::vector<double> &overlap,
                    const double               closed);
    /// Returns the point at @p t between @p from and @p to with its forces.
    Iterate
    interpolate_iterate(const ContactProblem &problem,
                        const Iterate        &from,
                        const Iterate        &to,
                        const double          t) const;
    /// Returns the minimum of the convex energy between @p from and @p to,
    /// whose active set was there before, where the forces do no more work, by
    /// bisection to 1 % of the initial work. The energy falls, so no set
    /// returns forever.
    Iterate
    energy_minimum(const ContactProblem &problem,
                   const Iterate        &from,
                   const Iterate        &to) const;

    PenaltyMatrix matrix;
  };
} // namespace lamella

#endif
