// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_condensed_strategy_h
#define lamella_solve_condensed_strategy_h

#include <lamella/linear/dense_cholesky.h>
#include <lamella/solve/compliance.h>
#include <lamella/solve/contact_strategy.h>
#include <lamella/solve/coulomb.h>

#include <optional>
#include <set>

namespace lamella
{
  /**
   * Static condensation onto the contact forces, the dual form of the problem:
   * K is factorised once per body; contact lives on the compliance C of the
   * rows that take part. Each linear solve is then one solution with K, one
   * small dense system,
   *   (C + d) dlambda = r_lambda - B K^-1 r_u,
   * and one backward half, K^-1 B^T dlambda. The penalty enters as d beside C,
   * never as K + K^p, so a hard one costs no digits.
   *
   * The active set is found by row generation: the complementarity problem of
   * the rows that take part is solved exactly (solve_complementarity()), the
   * gaps of all others are looked at, the worst of those that penetrate take
   * part from then on, at most as many as do already. Where most of them stay
   * open, as in a stack of bodies that close one after the other, those leave
   * again, each once: the energy grows with every round, whoever leaves without
   * a force, and since a row that has come back stays, this ends. Rows of
   * multipliers that others have closed
   * join last: where rows depend on each other (more points than a surface has
   * freedom to move) they then share the force, as the least sum of squares
   * does.
   *
   * Where none leave the rows that take part at least double in a round, and
   * there are about 2 + log2(rows / 8) rounds at most. With n of them, each
   * costs a dense factorisation or some (n^3 / 3) and the gaps of all rows;
   * memory is that of Compliance and n^2.
   */
  class CondensedStrategy : public ContactStrategy
  {
  public:
    /// @p linearisation must have solvers.
    CondensedStrategy(const Linearisation &linearisation, const GapRows &rows);

    /// Throws NumericsError as solve_complementarity() does, too.
    ContactSolution
    settle(const ContactProblem &problem, const Monitor &monitor) override;

    void
    solve(const ClosedRows  &closed,
          const BlockVector &r_u,
          const Vector      &r_lambda,
          BlockVector       &du,
          Vector            &dlambda) override;

    /// The stiffening and the batches of known rows.
    StrategyMemory
    memory() const override;

    /// Includes these batches again, which solves for them.
    void
    recall(const StrategyMemory &memory) override;

    bool
    forces_stand_alone() const override
    {
      return true;
    }

    std::string
    remedy() const override
    {
      return "a softer penalty";
    }

  private:
    /// The d of a known gap or slip: never less than 1e-10 of its compliance,
    /// which keeps C + d definite where rows depend on each other, nor than
    /// 1e-8 of what NumericalSoftness says, for rows without any compliance.
    /// `exact` takes this least value.
    double
    softness(const unsigned int number) const;

    /// The rows @p part, each followed by its slips if it has friction.
    std::vector<unsigned int>
    with_slips(const std::vector<unsigned int> &part) const;

    /// R K^-1 C + d of what is @p closed, column by column.
    std::vector<double>
    system_of(const ClosedRows &closed);
    /// lambda = (R K^-1 C + d)^-1 lambda: by Cholesky's factor, which is kept,
    /// where nothing slides. Throws NumericsError if it is singular.
    void
    solve_closed(const ClosedRows &closed, std::vector<double> &lambda);

    /// Rows with the negative of their gaps, the smallest gap first.
    using Violations = std::vector<std::pair<double, unsigned int>>;

    /// The rows to begin with: those that were active, have a force or are
    /// thought to have one, and those whose compliance is known unless most of
    /// them would be idle. None where no gap is closed and nothing is active.
    std::vector<unsigned int>
    first_part(const ContactProblem &problem) const;

    /// Rows without a softness of their own (a = 0) that touch under the gaps
    /// @p g, up to a hundred times what counts as closed, and are not among
    /// @p part.
    Violations
    touching_rows(const ContactProblem            &problem,
                  const std::vector<unsigned int> &part,
                  const std::vector<double>       &g) const;

    /// Solves @p problem on the rows @p part (known, ascending), beginning with
    /// those of them that are active in @p solution; all others keep the force
    /// that they have there. Sets du, the forces of @p part and the active
    /// rows.
    void
    solve_part(const ContactProblem            &problem,
               const std::vector<unsigned int> &part,
               ContactSolution                 &solution);

    /// The same with friction: by Coulomb's law on the compliance
    /// (solve_coulomb()), without any softness but the law's. Throws
    /// NumericsError where no forces obey it, or only unstable ones.
    void
    solve_with_friction(const ContactProblem            &problem,
                        const std::vector<unsigned int> &part,
                        ContactSolution                 &solution);
    /// What is to be solved for that, about the state, in which the rows have
    /// @p forces.
    CoulombProblem
    coulomb_problem(const ContactProblem            &problem,
                    const std::vector<unsigned int> &part,
                    const std::vector<double>       &forces) const;

    /// Takes those of @p part out of it that have no force and never had one,
    /// if that is most of them, and puts them among those that @p left; who
    /// left before stays.
    static void
    drop_idle(const ContactProblem      &problem,
              const ContactSolution     &solution,
              std::vector<unsigned int> &part,
              std::set<unsigned int>    &left);

    /// Of the rows that ever took part.
    Compliance compliance;
    /// The factor of C + d of the rows that were active in the last linear
    /// solve, these rows, and their d.
    std::optional<DenseCholesky> factor;
    std::vector<unsigned int>    factorised_for;
    std::vector<double>          factorised_with;
  };
} // namespace lamella

#endif
