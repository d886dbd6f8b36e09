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
   * Static condensation onto the contact forces, the dual form of the problem.
   * K is factorized once per body, and contact is solved with the compliance C
   * of the working set of rows. A linear solution takes one solution with K,
   * one small dense system
   *   (C + d) dlambda = r_lambda - B K^-1 r_u,
   * and one backward substitution K^-1 B^T dlambda. The penalty enters as the
   * compliance d beside C, never as K + K^p, so a hard penalty loses no digits.
   *
   * Row generation finds the active set. The complementarity problem of the
   * working set is solved exactly (solve_complementarity()); the gaps of all
   * other rows are evaluated; the most penetrating of these join, at most as
   * many as the set has. If most of the set stays open, such as in a stack of
   * bodies that close one after the other, idle rows are removed, each at most
   * once. Termination: the energy grows in every round, since a removed row has
   * no force, and a row that returns stays. Multiplier rows that close because
   * others have closed join last. Dependent rows (more contact points than
   * surface DoFs) share the force as in the least-squares solution. Without
   * removals, the working set at least doubles per round, so there are at most
   * about 2 + log2(rows / 8) rounds. For n rows, a round costs a few dense
   * factorizations (n^3 / 3) and the gaps of all rows.
   */
  class CondensedStrategy : public ContactStrategy
  {
  public:
    /// Refers to @p tangent_operator, which must have solvers.
    CondensedStrategy(const TangentOperator &tangent_operator,
                      const GapConstraints  &rows);

    /// Solves @p problem. Throws also as solve_complementarity() does.
    ContactSolution
    solve(const ContactProblem &problem, const Monitor &monitor) override;

    void
    solve(const ActiveConstraints &closed,
          const BlockVector       &r_u,
          const Vector            &r_lambda,
          BlockVector             &du,
          Vector                  &dlambda) override;

    /// Returns the increase of the penalty and the groups of included rows.
    StrategyHistory
    memory() const override;

    /// Includes the groups of @p memory again, which solves for them.
    void
    restore(const StrategyHistory &memory) override;

    bool
    forces_are_accurate() const override
    {
      return true;
    }

    std::string
    remedy() const override
    {
      return "a softer penalty";
    }

  private:
    /// Returns d of an included gap or slip, at least 1e-10 of the row's
    /// compliance, so that C + d is definite for dependent rows, and 1e-8 of
    /// NumericalCompliance. `exact` takes this lower bound.
    double
    compliance_of_law(const unsigned int number) const;

    /// Returns the rows @p part, each followed by its slips if it has friction.
    std::vector<unsigned int>
    with_slips(const std::vector<unsigned int> &part) const;

    /// Returns R K^-1 C + d of @p closed, column by column.
    std::vector<double>
    contact_system(const ActiveConstraints &closed);
    /// Replaces @p lambda by (R K^-1 C + d)^-1 lambda. The Cholesky factor is
    /// kept if nothing slips. Throws NumericsError if the matrix is singular.
    void
    solve_on_active_set(const ActiveConstraints &closed,
                        std::vector<double>     &lambda);

    /// Pairs of negative gap and row, the smallest gap first.
    using Violations = std::vector<std::pair<double, unsigned int>>;

    /// Returns the initial working set: rows that are active or have a force,
    /// and those included, unless most would be idle.
    std::vector<unsigned int>
    initial_working_set(const ContactProblem &problem) const;

    /// Returns the rows outside @p part without compliance (a = 0) that close
    /// under the gaps @p g, to a hundred times the tolerance.
    Violations
    touching_rows(const ContactProblem            &problem,
                  const std::vector<unsigned int> &part,
                  const std::vector<double>       &g) const;

    /// Solves @p problem on the rows @p part (included, ascending), from their
    /// active rows in @p solution; other rows keep their forces. Sets du, the
    /// forces of @p part and the active rows.
    void
    solve_working_set(const ContactProblem            &problem,
                      const std::vector<unsigned int> &part,
                      ContactSolution                 &solution);

    /// Solves @p problem as solve_working_set() does, with Coulomb's law
    /// (solve_coulomb()) and the compliance of the contact law only. Throws
    /// NumericsError without (stable) forces that satisfy the law.
    void
    solve_with_friction(const ContactProblem            &problem,
                        const std::vector<unsigned int> &part,
                        ContactSolution                 &solution);
    /// Returns the Coulomb problem on @p part about the state with @p forces.
    CoulombProblem
    coulomb_problem(const ContactProblem            &problem,
                    const std::vector<unsigned int> &part,
                    const std::vector<double>       &forces) const;

    /// Moves idle rows without force from @p part to @p left, if they are most
    /// of it. Rows that were removed before stay.
    static void
    remove_idle_rows(const ContactProblem      &problem,
                     const ContactSolution     &solution,
                     std::vector<unsigned int> &part,
                     std::set<unsigned int>    &left);

    /// Compliance of all rows that were ever in the working set.
    Compliance compliance;
    /// Factor of C + d of the last linear solution, its active rows, and d.
    std::optional<DenseCholesky> factor;
    std::vector<unsigned int>    factorized_for;
    std::vector<double>          factorized_with;
  };
} // namespace lamella

#endif
