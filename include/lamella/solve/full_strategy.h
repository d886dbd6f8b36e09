// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_full_strategy_h
#define lamella_solve_full_strategy_h

#include <lamella/solve/contact_strategy.h>
#include <lamella/solve/penalty_matrix.h>

namespace lamella
{
  /**
   * The paper's way: Newton's method on the displacements and contact forces of
   * the whole scene. At the state (u, lambda) a row is active if its law pushes
   * there,
   *   lambda - (g(u) + a lambda) / d > 0
   * (a semi-smooth Newton or primal-dual active set method; for penalties,
   * where d = a, this is g < 0), and the step is
   *   (K + K^p) du = r_u + B_A^T r_lambda / d,   K^p = B_A^T diag(1/d) B_A,
   *   dlambda      = (r_lambda - B_A du) / d
   * (Eqs. 22 and 23) with what is left at that state, r_lambda =
   * -(g(u) + a lambda), and r_u what is out of balance there. (Eq. 22 is in
   * total form; with residuals at the state the gaps are counted once, whatever
   * Eqs. 25 and 26 add to the right.) A factorisation of the whole scene for
   * each round: PenaltyMatrix. Each round's forces are the estimates of the
   * next.
   *
   * Globalisation: rows that pull open, of those that penetrate the worst
   * close, at most eight or, if that is more, as many as are active; should a
   * set come back, the step to it is cut at the lowest point of the energy
   * along it. With friction that is FrictionNewton.
   */
  class FullStrategy : public ContactStrategy
  {
  public:
    /// Assembles K of @p linearisation, which needs no solvers.
    FullStrategy(const Linearisation &linearisation, const GapRows &rows);

    ContactSolution
    settle(const ContactProblem &problem, const Monitor &monitor) override;

    /// One solution with K + K^p of the rows @p active.
    void
    solve(const ClosedRows  &closed,
          const BlockVector &r_u,
          const Vector      &r_lambda,
          BlockVector       &du,
          Vector            &dlambda) override;

    /// The stiffening, and the rows that the matrix has room for.
    StrategyMemory
    memory() const override;
    void
    recall(const StrategyMemory &memory) override;

    bool
    forces_stand_alone() const override
    {
      return false;
    }

    std::string
    remedy() const override
    {
      return rows.rub() ? "the condensed strategy" :
                          "a softer penalty, the condensed strategy";
    }

    /// That the penalties are too hard for doubles
    /// (PenaltyMatrix::warnings()).
    std::vector<std::string>
    warnings() const override
    {
      return matrix.warnings();
    }

  private:
    /// Where Newton's method is, about the state of the problem.
    struct Iterate
    {
      /// And K du from strains: penalties cost the matrix digits that the
      /// forces alone do not tell.
      BlockVector du, K_du;
      /// Of each row.
      std::vector<double> force;
      /// Ascending.
      std::vector<unsigned int> active;
    };

    /// Forces and rows that @p problem starts from, no displacement yet.
    Iterate
    begin(const ContactProblem &problem) const;
    /// The Newton step on the active rows of @p at; others lose their forces.
    /// Returns the largest change of a displacement.
    double
    step(const ContactProblem &problem, Iterate &at);
    /// d lambda - (g + a lambda) of each row, a length: its law's force times d
    /// where it is positive. For penalties, where d = a, it is the penetration
    /// -g.
    std::vector<double>
    overlaps(const ContactProblem &problem, const Iterate &at) const;
    /// Whether @p row is active and does not pull.
    static bool
    stays(const Iterate &at, const unsigned int row);
    /// The active rows that pull, and those of the others that overlap by more
    /// than @p closed.
    static Round
    wrong_rows(const Iterate             &at,
               const std::vector<double> &overlap,
               const double               closed);
    /// The next active set, ascending: those that stay, and the worst of those
    /// that overlap by more than @p closed, at most eight or as many as are
    /// active.
    static std::vector<unsigned int>
    next_set(const Iterate             &at,
             const std::vector<double> &overlap,
             const double               closed);
    /// @p from with the share @p t of the way to @p to, and the forces of the
    /// law there.
    Iterate
    part_of_the_way(const ContactProblem &problem,
                    const Iterate        &from,
                    const Iterate        &to,
                    const double          t) const;
    /// Where the forces do no work any more on the way from @p from to @p to,
    /// the whole of which led back to a set that had been there: by bisection,
    /// to a hundredth of their work at the start. For a convex energy that is
    /// its minimum along the way, so it falls, and no set comes back for ever.
    Iterate
    lowest_point(const ContactProblem &problem,
                 const Iterate        &from,
                 const Iterate        &to) const;

    PenaltyMatrix matrix;
  };
} // namespace lamella

#endif
