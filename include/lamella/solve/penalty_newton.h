// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_penalty_newton_h
#define lamella_solve_penalty_newton_h

#include <lamella/base/linear_algebra.h>
#include <lamella/linear/factorisation.h>
#include <lamella/solve/contact_solver.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>
#include <set>

namespace lamella
{
  /**
   * The paper's way (`full`): Newton's method on the displacements and contact
   * forces of the whole scene. At the state (u, lambda) a row is active if its
   * law pushes there,
   *   lambda - (g(u) + a lambda) / d > 0
   * (a semi-smooth Newton or primal-dual active set method; for penalties,
   * where d = a, this is g < 0), and the step is
   *   (K + K^p) du = r_u + B_A^T r_lambda / d,   K^p = B_A^T diag(1/d) B_A,
   *   dlambda      = (r_lambda - B_A du) / d
   * (Eqs. 22 and 23) with what is left at that state,
   *   r_u = t f - f_int(u) + B_A^T lambda,   r_lambda = -(g(u) + a lambda).
   * Nothing but K, which is taken as the tangent of f_int, knows that bodies
   * are linear. (Eq. 22 is in total form; with residuals at the state the gaps
   * are counted once, whatever Eqs. 25 and 26 add to the right.)
   *
   * K and K^p are assembled through the supports' AffineConstraints into
   * Trilinos' matrix. Its pattern has room for all rows that were active so far
   * (room for all that might be is many times the fill) and is analysed when
   * others join; MUMPS factorises it on all processes whenever the active set
   * or the stiffening changes. Time and memory are those of a factor of the
   * whole scene for each iteration. A hard penalty costs digits, as K drowns in
   * the rounding of K^p: warnings() tells how many.
   *
   * Globalisation: rows that pull open, of those that penetrate the worst
   * close, at most eight or, if that is more, as many as are active; should a
   * set come back, the step to it is cut at the lowest point of the energy
   * along it.
   *
   * Collective: all processes call all functions. Each owns a contiguous part
   * of the DoFs of all bodies, the rows of its share of the matrix.
   */
  class PenaltyNewton : public ContactSolver
  {
  public:
    /// Assembles K of @p linearisation, which needs no solvers; its structure
    /// and the rows must outlive this.
    PenaltyNewton(std::shared_ptr<const Linearisation> linearisation,
                  const GapRows                       &rows,
                  const SolverParameters &parameters = SolverParameters());
    /// About u = 0.
    PenaltyNewton(const Structure        &structure,
                  const GapRows          &rows,
                  const SolverParameters &parameters = SolverParameters());

    State
    solve_contact(const State &free,
                  const double factor,
                  const State &previous = State()) override;

    StrategyMemory
    memory() const override
    {
      // Which rows have room decides in which order MUMPS eliminates.
      return {softness.stiffening, {{known.begin(), known.end()}}};
    }

    void
    recall(const StrategyMemory &memory) override
    {
      softness.stiffening = memory.stiffening;
      for (const auto &rows_of_memory : memory.rows)
        known.insert(rows_of_memory.begin(), rows_of_memory.end());
      factor.reset();
      is_factorised = false;
    }

    /// A sentence if the hardest penalty so far leaves an error of more than
    /// 1e-4 by the estimate eps N t / k of Nour-Omid and Wriggers (1987; N
    /// DoFs, t the rounding of doubles), the reasoning behind Eq. 24
    /// (doc/penalty.md).
    std::vector<std::string>
    warnings() const override;

    /// One solution with K + K^p of the rows @p active, which is factorised
    /// first if it was not for these.
    void
    solve_linear(const std::vector<unsigned int> &active,
                 const BlockVector               &r_u,
                 const Vector                    &r_lambda,
                 BlockVector                     &du,
                 Vector                          &dlambda) override;

  protected:
    std::string
    remedy() const override
    {
      return "a softer penalty, the condensed strategy";
    }

  private:
    /// Those of the supports and theories of all bodies, u = G v, in the
    /// numbering of the scene: body after body.
    Constraints
    constraints_of_all() const;
    /// K of all bodies with their springs, condensed; diagonal entries of
    /// eliminated DoFs are the largest of all others.
    void
    assemble_stiffness();
    /// Makes room in K + K^p for the rows @p active, too; drops the factor and
    /// its symbolic analysis if some of them are new.
    void
    make_room(const std::vector<unsigned int> &active);
    /// Adds what the gap row @p row makes of K^p, b^T b / d (Eq. 23 with the
    /// row b in the place of n), at the softness d = @p softness_of_row.
    void
    add_penalty(const GapRow &row, const double softness_of_row);
    /// Makes `factor` that of K + K^p of the rows @p active, if it is not.
    void
    factorise(const std::vector<unsigned int> &active);
    /// The upper half of this process's entries of K + K^p, as triplets counted
    /// from 1: what MUMPS takes of a symmetric matrix.
    UpperTriangle
    upper_triangle() const;
    /// Keeps the hardest of the penalties of @p active over what the DoFs of
    /// the row offer, k = 1 / sum(b_i^2 / K_ii).
    void
    measure_hardness(const std::vector<unsigned int> &active);

    /// d lambda - (g + a lambda) of each row, a length: its law's force times d
    /// where it is positive. For penalties, where d = a, it is the penetration
    /// -g.
    std::vector<double>
    overlaps(const State &state, const double factor) const;
    /// Whether @p row is active in @p state and does not pull.
    bool
    stays(const State &state, const unsigned int row) const;
    /// The active rows that pull, and those of the others that overlap by more
    /// than @p closed.
    Round
    wrong_rows(const State               &state,
               const std::vector<double> &overlap,
               const double               closed) const;
    /// The next active set, ascending: those that stay, and the worst of those
    /// that overlap by more than @p closed, at most eight or as many as are
    /// active.
    std::vector<unsigned int>
    next_set(const State               &state,
             const std::vector<double> &overlap,
             const double               closed) const;
    /// The largest |g + a lambda| of active rows, a length.
    double
    law_error(const State &state, const double factor) const;
    /// @p from with the share @p t of the way @p du and the forces of the law
    /// there.
    State
    part_of_the_way(const State       &from,
                    const BlockVector &du,
                    const double       t,
                    const double       factor) const;
    /// Where the forces do no work any more on the way from @p from to @p to,
    /// the whole of which led back to a set that had been there: by bisection,
    /// to a hundredth of their work at the start. For a convex energy that is
    /// its minimum along the way, so it falls, and no set comes back for ever.
    State
    lowest_point(const State &from, const State &to, const double factor) const;

    /// d of each row.
    NumericalSoftness softness;
    /// constraints_of_all().
    Constraints constraints;
    /// Of a process: a contiguous part of the DoFs of all bodies.
    dealii::IndexSet owned;
    /// K, and K + K^p of the last active set; this process's rows of each.
    SharedMatrix stiffness, system;
    /// That of K, whole on each process.
    Vector diagonal;
    /// Of `system`; null until it is analysed.
    std::unique_ptr<RepeatedFactorisation> factor;
    /// The rows that `system` has room for.
    std::set<unsigned int> known;
    /// What `factor` was made for: rows and stiffening.
    std::vector<unsigned int> factorised_for;
    double                    factorised_with = 0.;
    bool                      is_factorised   = false;

    /// The largest eps / k so far, a number, and its eps (force / length).
    double hardest = 0., hardest_penalty = 0.;
  };
} // namespace lamella

#endif
