// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/contact_newton.h>
#include <lamella/solve/full_strategy.h>
#include <lamella/solve/interior_point.h>
#include <lamella/solve/sparse_interface_system.h>

// Newton's method on displacements and forces of the whole scene with the
// penalty matrix K + K^p (Eqs. 22 and 23 of the paper): the semi-smooth Newton
// or primal-dual active set method (Hintermueller, Ito and Kunisch, SIAM J.
// Optim. 13 (2002) 865-888). The complementarity conditions are written as
//   lambda = max(0, lambda - rho (g + a lambda)),   rho > 0,
// with a generalized derivative of 1 on the active set, 0 elsewhere.
//
// Stages: ContactNewton; the interior point first, where forces are too far.
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



  // Newton's method from the forces of the previous load step; without them, or
  // if it does not converge soon, from the result of the interior point.
  ContactSolution
  FullStrategy::solve(const ContactProblem &problem, const Monitor &monitor)
  {
    constexpr unsigned int near = 12, until_monitor_ends = -1;

    ContactNewton newton(tangent_operator, rows, numerical_compliance, matrix);
    const ContactNewton::Iterate first   = newton.begin(problem);
    const bool                   is_warm = largest_component(first.force) > 0.;
    if (const auto found =
          newton.solve(problem, first, monitor, is_warm ? near : 0))
      return *found;

    ContactNewton::Iterate start;
    {
      // Its matrix is released before Newton's method needs another.
      SparseInterfaceSystem system(tangent_operator,
                                   rows,
                                   numerical_compliance,
                                   problem);
      start.force  = solve_by_interior_point(system,
                                            system.points(),
                                            problem.forces(),
                                            monitor);
      start.du     = std::move(system.du);
      start.K_du   = std::move(system.K_du);
      start.change = start.du.linfty_norm();
    }
    return *newton.solve(problem,
                         std::move(start),
                         monitor,
                         until_monitor_ends);
  }
} // namespace lamella
