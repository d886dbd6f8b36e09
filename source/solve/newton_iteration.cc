// SPDX-License-Identifier: LGPL-2.1-or-later

// An iteration of Newton's method: the tangent, the contact problem on it, and
// what rows turn by.

#include <lamella/base/exceptions.h>
#include <lamella/solve/contact_strategy.h>
#include <lamella/solve/friction_step.h>
#include <lamella/solve/ill_conditioned.h>
#include <lamella/solve/newton.h>

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_gmres.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace lamella
{
  namespace
  {
    BlockVector
    sum_of(const BlockVector &a, const BlockVector &b)
    {
      BlockVector sum = a;
      sum += b;
      return sum;
    }



    /// x - answer(x), as GMRES asks for it.
    struct WithRotatingConstraints
    {
      std::function<BlockVector(const BlockVector &)> answer;
      void
      vmult(BlockVector &to, const BlockVector &x) const
      {
        to = x;
        to -= answer(x);
      }
    };
  } // namespace



  ContactSolution
  Newton::solve_contact(ContactStrategy      &strategy,
                        const GapConstraints &rows,
                        const LoadFactor     &to,
                        State                &state) const
  {
    ContactProblem problem;
    for (const GapConstraint &row : rows)
      problem.gap.push_back(row.gap(state.u, to));
    problem.force = problem.estimate = state.force;
    problem.start                    = state.active;
    problem.closed                   = parameters.touching * structure.size();
    if (!state.friction.empty())
      add_friction(rows, state, to, problem);
    ContactSolution found =
      strategy.solve(problem, [this, rounds = 0u](const Round &round) mutable {
        if (++rounds > parameters.max_iterations)
          throw NumericsError(
            "solve.not-converged: The contact did not converge in " +
            std::to_string(rounds - 1) + " rounds. Raise Maximum iterations.");
        if (!round.changed.empty())
          progress("  contact: " + std::to_string(round.active) +
                   " rows active, " + std::to_string(round.changed.size()) +
                   " change");
      });
    store_forces(rows, found, state);
    return found;
  }



  BlockVector
  Newton::rotation_of_constraints(const State       &state,
                                  const BlockVector &u,
                                  const BlockVector &w,
                                  const LoadFactor  &to) const
  {
    BlockVector  f      = structure.zero();
    const double length = length_of(w);
    if (length == 0.)
      return f;
    const double step = parameters.difference * structure.size() / length;
    for (const double way : {step, -step})
      {
        BlockVector change = w, at = structure.zero();
        change *= way;
        if (!contacts.add_forces_at(
              state, structure.retract(u, change), to, at))
          return structure.zero();
        f.add(0.5 / way, at);
      }
    return f;
  }



  BlockVector
  Newton::correct_row_rotation(ContactStrategy   &strategy,
                               const BlockVector &u,
                               const BlockVector &du,
                               const double       regularization_factor,
                               const LoadFactor  &to,
                               State             &state) const
  {
    if (state.active.empty())
      return du;
    // Those that slip push along with their normal force.
    const ActiveConstraints closed = active_equations(contacts.rows(), state);
    const Vector            held(closed.numbers.size());
    Vector                  forces;
    const auto              answer = [&](const BlockVector &w) {
      BlockVector x = structure.zero(),
                  f = rotation_of_constraints(state, u, w, to);
      add_spring_forces(regularization_factor, w, f);
      strategy.solve(closed, f, held, x, forces);
      return x;
    };
    const double          enough = parameters.rotation_tolerance * du.l2_norm();
    dealii::SolverControl control(parameters.max_rotation_corrections,
                                  enough,
                                  false,
                                  false);
    BlockVector           x = answer(du);
    if (x.l2_norm() > enough)
      try
        {
          x += du;
          dealii::SolverGMRES<BlockVector>(control).solve(
            WithRotatingConstraints{answer},
            x,
            du,
            dealii::PreconditionIdentity());
          x = answer(x);
        }
      catch (const dealii::SolverControl::NoConvergence &)
        {
          return du;
        }
    x += du;
    // What no row holds without springs stays with them, until rows do.
    if (structure.has_springs() &&
        length_of(x) > parameters.max_spring_influence * length_of(du))
      return du;
    // To first order; the next iteration says which rows are active.
    add_forces(contacts.rows(), closed, forces, state);
    for (const unsigned int row : state.active)
      if (state.force[row] < 0.)
        {
          state.force[row] = 0.;
          if (!state.friction.empty())
            state.friction.shear[row] = dealii::Tensor<1, 3>();
        }
    return x;
  }



  void
  Newton::check_stability(const BlockVector &before,
                          const Correction  &last,
                          const State       &state,
                          const LoadFactor  &to) const
  {
    if (last.is_unstable)
      throw_unstable();
    if (structure.has_springs() && check_supports(state, to))
      return;
    BlockVector way = state.u;
    way -= before;
    if (!last.uses_constraint_shift &&
        length_of(last.du) <= parameters.converged_step * length_of(way))
      return;
    Regularization none;
    tangent(state, BlockVector(), to, none);
  }



  Newton::Correction
  Newton::correct(const BlockVector &r,
                  const BlockVector &moved,
                  const BlockVector &correction,
                  const LoadFactor  &to,
                  State             &state) const
  {
    Regularization        regularization;
    const TangentOperator about =
      tangent(state, correction, to, regularization);
    const auto       &shift    = regularization.shift;
    const BlockVector before   = state.u;
    BlockVector       du       = about.solve(r);
    bool              unstable = false;
    du += moved;
    if (!contacts.none())
      {
        const GapConstraints rows = shift ? shift->rows() : contacts.rows();
        const auto strategy = make_strategy(Strategy::condensed, about, rows);
        // Gaps are those of the tangent planes, whose states are sums.
        if (shift)
          shift->remove_shift(sum_of(before, moved), to, state);
        state.u += du;
        const ContactSolution transfer =
          solve_contact(*strategy, rows, to, state);
        du += transfer.du;
        unstable = transfer.is_unstable;
        if (shift)
          shift->apply_shift(sum_of(before, du), to, state);
        du = correct_row_rotation(*strategy,
                                  before,
                                  du,
                                  regularization.regularization_factor,
                                  to,
                                  state);
      }
    shorten(du);
    state.u = structure.retract(before, du);
    // In the tangent alone: nowhere they bear a force.
    if (structure.has_springs())
      state.rest = structure.spring_lengths(state.u);
    return {std::move(du), shift != nullptr, unstable};
  }
} // namespace lamella
