// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/solve/full_strategy.h>
#include <lamella/solve/interface_solver.h>
#include <lamella/solve/sparse_interface_system.h>

// Newton's method on displacements and forces of the whole scene with the
// penalty matrix K + K^p (Eqs. 22 and 23 of the paper): the semi-smooth Newton
// or primal-dual active set method (Hintermueller, Ito and Kunisch, SIAM J.
// Optim. 13 (2002) 865-888). The complementarity conditions are written as
//   lambda = max(0, lambda - rho (g + a lambda)),   rho > 0,
// with a generalized derivative of 1 on the active set, 0 elsewhere.
//
// The laws and both stages are those of solve_interface(). Each Newton step
// factorizes K + K^p with the linearized laws (SparseInterfaceSystem).
namespace lamella
{
  FullStrategy::FullStrategy(const TangentOperator &tangent_operator,
                             const GapConstraints  &rows)
    : ContactStrategy(tangent_operator, rows)
    , matrix(tangent_operator,
             rows,
             rows.has_friction() ? Symmetry::none : Symmetry::definite)
  {}



  StrategyHistory
  FullStrategy::memory() const
  {
    return {numerical_compliance.stiffening, {matrix.known_rows()}};
  }



  void
  FullStrategy::restore(const StrategyHistory &memory)
  {
    numerical_compliance.stiffening = memory.stiffening;
    for (const std::vector<unsigned int> &known : memory.rows)
      matrix.restore(known);
  }



  // (K + K^p) du = r_u + B^T D^-1 r_lambda, dlambda = D^-1 (r_lambda - B du),
  // with D = diag(d) and, for slipping rows, the term mu e B_t^T D^-1 B_n.
  void
  FullStrategy::solve(const ActiveConstraints &closed,
                      const BlockVector       &r_u,
                      const Vector            &r_lambda,
                      BlockVector             &du,
                      Vector                  &dlambda)
  {
    const std::vector<unsigned int> &numbers = closed.numbers;
    const auto compliance                    = [&](const unsigned int number) {
      return numerical_compliance(rows[rows.row_of(number)]);
    };
    std::vector<PenaltyTerm> terms;
    for (const unsigned int number : numbers)
      terms.push_back({number, number, 1. / compliance(number)});
    for (const auto &[r, along] : closed.sliding)
      for (unsigned int a = 0; a < rows[r].slips.size(); ++a)
        terms.push_back({rows.slip(r, a), r, along[a] / compliance(r)});
    matrix.factorize(terms);

    du = r_u;
    std::vector<double> pushed(rows.size(), 0.);
    for (unsigned int k = 0; k < numbers.size(); ++k)
      {
        const double force = r_lambda[k] / compliance(numbers[k]);
        rows.constraint(numbers[k]).add_to(du, force);
        if (numbers[k] < rows.size())
          pushed[numbers[k]] = force;
      }
    for (const auto &[r, along] : closed.sliding)
      add_force(rows[r], 0., in_scene(rows[r], pushed[r] * along), du);
    du = matrix.solve(std::move(du));
    dlambda.reinit(numbers.size());
    for (unsigned int k = 0; k < numbers.size(); ++k)
      dlambda[k] = (r_lambda[k] - rows.constraint(numbers[k]).jump(du)) /
                   compliance(numbers[k]);
  }



  namespace
  {
    /// Returns the solution of @p problem with the forces @p found and the
    /// displacement increment @p du.
    ContactSolution
    solution_of(const ContactProblem    &problem,
                const GapConstraints    &rows,
                const InterfaceSolution &found,
                const BlockVector       &du)
    {
      const PointVectors before = problem.forces();
      ContactSolution    result;
      std::vector<bool>  moved(du.n_blocks(), problem.residual.size() > 0);
      result.force.assign(rows.size(), 0.);
      result.shear.assign(rows.size(), {});
      result.direction.assign(rows.size(), {});
      for (unsigned int r = 0; r < rows.size(); ++r)
        {
          result.store(r, found.states[r], found.force[r]);
          if (found.force[r] != before[r])
            for (const BodyFunctional &part : rows[r].parts)
              moved[part.body] = true;
        }
      result.is_unstable = found.stability < 0;
      result.du          = du;
      // Bodies without a change of forces have only rounding in du.
      for (unsigned int b = 0; b < moved.size(); ++b)
        if (!moved[b])
          result.du.block(b) = 0.;
      return result;
    }
  } // namespace



  // Newton's method from the forces of the previous load step; without them, or
  // if it does not converge soon, from the result of the interior point.
  ContactSolution
  FullStrategy::solve(const ContactProblem &problem, const Monitor &monitor)
  {
    PointVectors start(rows.size());
    if (!problem.first_forces.empty())
      start = problem.first_forces;
    else
      for (const unsigned int r : problem.start)
        start[r][0] = problem.estimate[r];
    InterfaceRules rules;
    rules.tolerance        = arithmetic::rounding_of_solutions;
    rules.extra_iterations = 0;
    if (largest_component(start) == 0.)
      rules.first_iterations = problem.residual.size() > 0 ? 1 : 0;

    SparseInterfaceSystem system(
      tangent_operator, rows, numerical_compliance, problem, matrix);
    const InterfaceSolution found =
      solve_interface(system, system.points(), start, monitor, rules);
    check_law(found, rows.has_friction());
    if (!(found.error < rules.tolerance))
      system.move_to(found.force);
    ContactSolution solution =
      solution_of(problem, rows, found, system.displacement());
    ++solution.solved_by[static_cast<unsigned int>(found.by)];
    return solution;
  }
} // namespace lamella
