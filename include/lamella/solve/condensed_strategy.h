// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_condensed_strategy_h
#define lamella_solve_condensed_strategy_h

#include <lamella/linear/dense_lu.h>
#include <lamella/solve/contact_strategy.h>
#include <lamella/solve/interface_solver.h>
#include <lamella/solve/interface_system.h>

#include <optional>
#include <set>

namespace lamella
{
  /// Contact solver by static condensation onto the contact forces, the dual
  /// form of the problem. The stiffness K is factorized once per body. Contact
  /// is solved with the compliance C (Compliance) of a working set of
  /// constraints. A linear system with active constraints is solved in three
  /// steps: a solution with K, a small dense system
  ///   (C + d) dlambda = r_lambda - B K^-1 r_u,
  /// and one backward substitution K^-1 B^T dlambda, with constraint rows B and
  /// the residuals r_u of equilibrium and r_lambda of the contact law. The
  /// penalty enters as a compliance d, so a hard penalty loses no digits.
  ///
  /// The active set is found by constraint generation. Each round solves the
  /// contact problem of the working set exactly (solve_interface(),
  /// solve_coulomb()) and evaluates the gaps of all other constraints.
  /// Constraints that penetrate most are added: at most eight, or as many as
  /// the set has if it has more. Constraints without penalty whose gap closes
  /// without a force are added once, at the end. If most of the working set is
  /// open, open constraints are removed, each at most once. Dependent
  /// constraints (more contact points than surface DoFs) share the force as in
  /// the least-squares solution.
  class CondensedStrategy : public ContactStrategy
  {
  public:
    /// Keeps references; @p tangent_operator must have factorizations.
    CondensedStrategy(const TangentOperator &tangent_operator,
                      const GapConstraints  &rows);

    /// Finds the active set and the increment of @p problem. Also throws the
    /// exceptions of check_law().
    ContactSolution
    solve(const ContactProblem &problem, const Monitor &monitor) override;

    void
    solve(const ActiveConstraints &closed,
          const BlockVector       &r_u,
          const Vector            &r_lambda,
          BlockVector             &du,
          Vector                  &dlambda) override;

    /// Returns the penalty factor and the indices of all constraints in the
    /// compliance, which a restarted run needs.
    StrategyHistory
    memory() const override;

    /// Restores the penalty factor and the compliance from @p memory.
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
    /// Returns the solution of @p problem, which has a residual.
    ContactSolution
    solve_balanced(ContactProblem problem, const Monitor &monitor);

    /// Returns the regularization d of gap or slip @p number [length / force]:
    /// NumericalCompliance, or 1e-8 of it for the method `exact`; at least
    /// 1e-10 of the diagonal entry of C, so that C + d is positive definite.
    double
    compliance_of_law(const unsigned int number) const;

    /// Returns the gaps @p part, each followed by the indices of its slips.
    std::vector<unsigned int>
    with_slips(const std::vector<unsigned int> &part) const;

    /// Returns the matrix R K^-1 F + d of the active constraints @p closed,
    /// column by column, with rows R, and nodal forces F due to unit contact
    /// forces.
    std::vector<double>
    contact_system(const ActiveConstraints &closed);
    /// Replaces @p lambda by the solution of contact_system() with the
    /// right-hand side @p lambda. The Cholesky factor is kept if no point
    /// slips. Throws NumericsError if the matrix is singular.
    void
    solve_on_active_set(const ActiveConstraints &closed,
                        std::vector<double>     &lambda);

    /// Penetrations and indices of constraints, the deepest penetration first.
    using Violations = std::vector<std::pair<double, unsigned int>>;

    /// Returns the initial working set: constraints that are active or have a
    /// force, and those with known compliance unless most would be open.
    std::vector<unsigned int>
    initial_working_set(const ContactProblem &problem) const;

    /// Returns the constraints without penalty, outside @p part, whose gaps @p
    /// g are below a hundred times ContactProblem::closed.
    Violations
    touching_rows(const ContactProblem            &problem,
                  const std::vector<unsigned int> &part,
                  const std::vector<double>       &g) const;

    /// Solves @p problem on the constraints @p part (ascending), starting from
    /// their active set in @p solution. Other constraints keep their forces.
    /// Sets du, the forces of @p part and the active set of @p solution. With
    /// friction, there is no numerical compliance.
    void
    solve_working_set(const ContactProblem            &problem,
                      const std::vector<unsigned int> &part,
                      ContactSolution                 &solution);

    /// Returns the solution of @p small, the problem of the frictionless
    /// constraints @p part, with the numerical compliance d, from the forces
    /// @p start.
    InterfaceSolution
    frictionless(const ContactProblem            &problem,
                 const std::vector<unsigned int> &part,
                 const CoulombProblem            &small,
                 const PointVectors              &start) const;
    /// Returns the problem of the constraints @p part, with gaps and slips at
    /// the contact forces @p forces.
    CoulombProblem
    coulomb_problem(const ContactProblem            &problem,
                    const std::vector<unsigned int> &part,
                    const std::vector<double>       &forces) const;

    /// Moves open constraints from @p part to @p left if most of @p part are
    /// open; those already in @p left stay, since none is removed twice.
    static void
    remove_idle_rows(const ContactProblem      &problem,
                     const ContactSolution     &solution,
                     std::vector<unsigned int> &part,
                     std::set<unsigned int>    &left);

    /// Compliance of all constraints that were ever in the working set.
    Compliance compliance;
    /// Last Cholesky factor of C + d, its constraints, and their d.
    std::optional<DenseCholesky> factor;
    std::vector<unsigned int>    factorized_for;
    std::vector<double>          factorized_with;
  };
} // namespace lamella

#endif
