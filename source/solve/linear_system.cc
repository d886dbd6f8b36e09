// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/solve/friction_step.h>
#include <lamella/solve/linear_system.h>

#include <algorithm>
#include <cmath>

// Iterative refinement of displacements and forces against the residual from
// strains (Higham, Accuracy and Stability of Numerical Algorithms, SIAM 2002,
// Ch. 12). Tolerances are relative to the displacements (displacement_scale()),
// as gaps are differences of displacements.
namespace lamella
{
  using namespace dealii;

  // The strategy refers to the tangent operator, which this object shares.
  LinearSystem::LinearSystem(std::shared_ptr<const TangentOperator> tangent,
                             const GapConstraints                  &rows,
                             const NonlinearParameters             &parameters,
                             const Strategy                         which)
    : tangent_operator(std::move(tangent))
    , structure(tangent_operator->of())
    , rows(rows)
    , parameters(parameters)
    , strategy(make_strategy(which, *tangent_operator, rows))
  {}



  // Reference length of all tolerances: the maximum norm of displacements,
  // obstacle motions and accumulated slips.
  double
  LinearSystem::displacement_scale(const State      &state,
                                   const LoadFactor &factor) const
  {
    // Gaps are differences of displacements and motions of obstacles.
    double size = state.u.linfty_norm();
    for (const GapConstraint &row : rows)
      size = std::max(size, std::abs(factor.of(row.history) * row.gap_rate));
    // Slips since the start count, as a body may return to its initial place.
    for (const Tensor<1, 3> &slip : state.friction.before)
      size = std::max(size, slip.norm());
    return size;
  }



  // Proportional loads: multiples of the solution at load factor 1, which does
  // not depend on the load steps before, so that restarts give the same digits.
  State
  LinearSystem::solve_free(const LoadFactor &factor)
  {
    if (!structure.is_proportional())
      return refined_solution(factor);
    if (unit_solution.u.n_blocks() == 0)
      unit_solution = refined_solution(factor.of_scene_alone());
    State state = unit_solution;
    state.u *= factor.of_scene();
    for (double &size : state.free_sizes)
      size *= std::abs(factor.of_scene());
    return state;
  }



  // Linear solution without contact by iterative refinement from u = u_p(t).
  State
  LinearSystem::refined_solution(const LoadFactor &factor)
  {
    State state;
    state.u = structure.particular(factor);
    state.force.assign(rows.size(), 0.);
    // u = u_p(t) satisfies the supports; corrections are zero in prescribed
    // DoFs.
    // The first correction is the solution itself, the second a refinement.
    state.free_corrections = refine(state, factor, 2);
    state.free_corrections.erase(state.free_corrections.begin());
    for (unsigned int b = 0; b < state.u.n_blocks() && !structure.has_springs();
         ++b)
      state.free_sizes.push_back(state.u.block(b).linfty_norm());
    return state;
  }



  // All closed rows as sticking: the symmetric tangent for small disturbances.
  ActiveConstraints
  LinearSystem::sticking_equations(const State &state) const
  {
    ActiveConstraints held(state.active);
    for (const unsigned int r : state.active)
      for (unsigned int a = 0; a < rows[r].slips.size(); ++a)
        held.numbers.push_back(rows.slip(r, a));
    return held;
  }



  // r_lambda = -(g + a lambda) for gaps, -v for the slips of sticking rows.
  Vector
  LinearSystem::law_residual(const State             &state,
                             const LoadFactor        &factor,
                             const ActiveConstraints &closed) const
  {
    Vector residual(closed.numbers.size());
    for (unsigned int i = 0; i < residual.size(); ++i)
      {
        const unsigned int number = closed.numbers[i], r = rows.row_of(number);
        residual[i] =
          number == r ?
            -(rows[r].gap(state.u, factor) +
              law_compliance(rows[r]) * state.force[r]) :
            -slip_in_step(rows[r], r, state, factor)[number - rows.slip(r, 0)];
      }
    return residual;
  }



  // One correction of iterative refinement: residuals at the state, a linear
  // solution with the active set fixed, and the update of u and lambda.
  double
  LinearSystem::correct(State &state, const LoadFactor &factor)
  {
    BlockVector r_u = structure.residual(state.u, factor, state.rest);
    // All forces, also those of rows without an equation
    // (refine_contact()).
    for (unsigned int r = 0; r < rows.size() && !state.force.empty(); ++r)
      if (state.force[r] != 0. || rows[r].is_tied())
        add_force(rows[r],
                  state.force[r],
                  state.friction.empty() ? Tensor<1, 3>() :
                                           state.friction.shear[r],
                  r_u);
    const ActiveConstraints closed = active_equations(rows, state);
    BlockVector             du;
    Vector                  dlambda;
    strategy->solve(
      closed, r_u, law_residual(state, factor, closed), du, dlambda);
    state.u += du;
    add_forces(rows, closed, dlambda, state);

    // The test catches NaN, too.
    const double size   = displacement_scale(state, factor),
                 change = du.l2_norm();
    if (!std::isfinite(change))
      throw NumericsError(
        "solve.not-finite: The solution is not finite. Check the loads.");
    return change <= state.rounding() ? 0. : du.linfty_norm() / size;
  }



  // Stopping criteria of iterative refinement (Higham, Ch. 12): a tolerance,
  // a ratio above 1/2 of successive corrections, a limit.
  bool
  LinearSystem::is_refined(const std::vector<double> &corrections,
                           const unsigned int         at_least) const
  {
    // Tolerance, rounding of the residual, or limit reached.
    const unsigned int n = corrections.size();
    return n >= at_least &&
           (corrections.back() < parameters.refinement_tolerance ||
            (n > at_least && corrections[n - 1] > 0.5 * corrections[n - 2]) ||
            n >= parameters.max_refinements + at_least);
  }



  // Iterative refinement in fixed precision: the residual from strains is more
  // accurate than the matrix, so each correction gains digits.
  std::vector<double>
  LinearSystem::refine(State             &state,
                       const LoadFactor  &factor,
                       const unsigned int at_least)
  {
    std::vector<double> corrections;
    do
      corrections.push_back(correct(state, factor));
    while (!is_refined(corrections, at_least));
    return corrections;
  }



  // Equations of active constraints are replaced by their forces if one of them
  // would pull: forces of dependent rows are not unique.
  void
  LinearSystem::refine_contact(State &state, const LoadFactor &factor)
  {
    State refined               = state;
    refined.contact_corrections = refine(refined, factor, 1);
    if (std::none_of(state.active.begin(),
                     state.active.end(),
                     [&](const unsigned int r) {
                       return refined.force[r] < 0. && !rows[r].is_tied();
                     }))
      {
        state = std::move(refined);
        return;
      }
    const std::vector<unsigned int> active = std::move(state.active);
    state.active.clear();
    state.contact_corrections = refine(state, factor, 1);
    state.active              = active;
  }
} // namespace lamella
