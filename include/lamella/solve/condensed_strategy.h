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
  /// Contact solver by static condensation onto the contact forces, the dual
  /// form of the problem. The stiffness K is factorized once per body, and
  /// contact is solved with the compliance C (Compliance) of a working set of
  /// constraints. A linear solution takes one with K, a small dense system
  ///   (C + d) dlambda = r_lambda - B K^-1 r_u,
  /// and one backward substitution K^-1 B^T dlambda, with constraint rows B and
  /// the residuals r_u of equilibrium and r_lambda of the contact law. The
  /// penalty enters as a compliance d, so a hard penalty loses no digits.
  ///
  /// The active set is found by constraint generation. In each round, the
  /// complementarity problem of the working set is solved exactly
  /// (solve_complementarity()), and the gaps of all other constraints are
  /// evaluated. Those that penetrate most are added: at most eight, or as many
  /// as the set has. Constraints without penalty whose gap closes without a
  /// force are added once, at the end. If most of the set is idle (open), idle
  /// constraints are removed, each at most once. Dependent constraints (more
  /// contact points than surface DoFs) share the force as in the least-squares
  /// solution. A round costs a few dense factorizations.
  class CondensedStrategy : public ContactStrategy
  {
  public:
    /// Keeps a reference to @p tangent_operator, which must have solvers.
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

    /// Returns the penalty factor and the constraints in the compliance.
    StrategyHistory
    memory() const override;

    /// Restores the penalty factor and the constraints in the compliance.
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
    /// Returns the compliance d of gap or slip @p number, which must be in the
    /// compliance C: at least 1e-10 of the diagonal entry of C, so that C + d
    /// is definite, and 1e-8 of NumericalCompliance. `exact` uses this bound.
    double
    compliance_of_law(const unsigned int number) const;

    /// Returns the constraints @p part, each followed by its slips, if any.
    std::vector<unsigned int>
    with_slips(const std::vector<unsigned int> &part) const;

    /// Returns the matrix R K^-1 C + d of ContactStrategy::solve() for
    /// @p closed, with rows R and force columns C, column by column.
    std::vector<double>
    contact_system(const ActiveConstraints &closed);
    /// Replaces @p lambda by (R K^-1 C + d)^-1 lambda. The Cholesky factor is
    /// stored if no point slips. Throws NumericsError if singular.
    void
    solve_on_active_set(const ActiveConstraints &closed,
                        std::vector<double>     &lambda);

    /// Penetration and constraint number, the deepest penetration first.
    using Violations = std::vector<std::pair<double, unsigned int>>;

    /// Returns the initial working set: constraints that are active or have a
    /// force, and those in the compliance, unless most of these would be open.
    std::vector<unsigned int>
    initial_working_set(const ContactProblem &problem) const;

    /// Returns the constraints outside @p part of multiplier methods (a = 0)
    /// that are closed by the gaps @p g, to a hundred times the tolerance.
    Violations
    touching_rows(const ContactProblem            &problem,
                  const std::vector<unsigned int> &part,
                  const std::vector<double>       &g) const;

    /// Solves @p problem on the constraints @p part (included, ascending),
    /// starting from their active set in @p solution; other constraints keep
    /// their forces. Sets du, the forces of @p part and the active set.
    void
    solve_working_set(const ContactProblem            &problem,
                      const std::vector<unsigned int> &part,
                      ContactSolution                 &solution);

    /// Solves @p problem as solve_working_set() does, with Coulomb's law
    /// (solve_coulomb()) and the compliance of the contact law only. Throws
    /// NumericsError if no stable forces satisfy the law.
    void
    solve_with_friction(const ContactProblem            &problem,
                        const std::vector<unsigned int> &part,
                        ContactSolution                 &solution);
    /// Returns the problem of the constraints @p part for solve_coulomb(), with
    /// gaps and slips at the contact forces @p forces.
    CoulombProblem
    coulomb_problem(const ContactProblem            &problem,
                    const std::vector<unsigned int> &part,
                    const std::vector<double>       &forces) const;

    /// Moves idle constraints without force from @p part to @p left if most of
    /// @p part is idle. Constraints that are in @p left stay in @p part.
    static void
    remove_idle_rows(const ContactProblem      &problem,
                     const ContactSolution     &solution,
                     std::vector<unsigned int> &part,
                     std::set<unsigned int>    &left);

    /// Compliance of all constraints that were ever in the working set.
    Compliance compliance;
    /// Last Cholesky factor of C + d, its active constraints, and d of each.
    std::optional<DenseCholesky> factor;
    std::vector<unsigned int>    factorized_for;
    std::vector<double>          factorized_with;
  };
} // namespace lamella

#endif
