// SPDX-License-Identifier: LGPL-2.1-or-later

// One iteration of Newton's method with contact. About the state u:
// 1. factorize the tangent K (newton_springs.cc regularizes it if needed);
// 2. du = K^-1 r + support motion, without a change of contact forces;
// 3. solve the contact problem of the linearized gaps g + B du for forces and
//    active set by static condensation (Wriggers, Computational Contact
//    Mechanics, Springer 2006, Ch. 10; CondensedStrategy);
// 4. correct du for the rotation of the normals, H = sum lambda Hess g, by
//    GMRES preconditioned with the solution of step 3;
// 5. update the state multiplicatively, u <- retract(u, du).

#include <lamella/base/exceptions.h>
#include <lamella/solve/contact_strategy.h>
#include <lamella/solve/friction_step.h>
#include <lamella/solve/ill_conditioned.h>
#include <lamella/solve/newton.h>

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_gmres.h>

#include <utility>

namespace lamella
{
  namespace
  {
    // Sum of two states; valid for increments of the linearized problem.
    BlockVector
    sum_of(const BlockVector &a, const BlockVector &b)
    {
      BlockVector sum = a;
      sum += b;
      return sum;
    }



    /// Returns a strategy for @p rows, by choose_strategy() for their gaps at
    /// the displacements @p u and load factor @p to, less the tolerance
    /// @p closed.
    std::unique_ptr<ContactStrategy>
    strategy_at(const Strategy         which,
                const TangentOperator &about,
                const GapConstraints  &rows,
                const BlockVector     &u,
                const LoadFactor      &to,
                const double           closed)
    {
      if (which != Strategy::automatic || !rows.has_friction())
        return make_strategy(which, about, rows);
      std::vector<GapConstraint> here(rows.begin(), rows.end());
      for (GapConstraint &row : here)
        row.initial_gap = row.gap(u, to) - closed;
      return make_strategy(
        choose_strategy(which, about.of(), GapConstraints(here)), about, rows);
    }



    /// The operator 1 - A of GMRES, with A x = answer(x).
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



  // The problem has total forces as multiplier estimates (method of
  // multipliers, Simo and Laursen, Comput. Struct. 42 (1992) 97-116).
  ContactSolution
  Newton::solve_contact(ContactStrategy      &strategy,
                        const GapConstraints &rows,
                        const BlockVector    &r,
                        const LoadFactor     &to,
                        State                &state) const
  {
    ContactProblem problem;
    problem.residual = r;
    for (const GapConstraint &row : rows)
      problem.gap.push_back(row.gap(state.u, to));
    problem.force = problem.estimate = state.force;
    problem.start                    = state.active;
    problem.closed                   = parameters.touching * structure.size();
    if (!state.friction.empty())
      add_friction(rows, state, to, problem);
    ContactSolution found =
      strategy.solve(problem, [this, rounds = 0u](const Round &round) mutable {
        if (round.counts && ++rounds > parameters.max_iterations)
          throw NumericsError(
            "solve.not-converged: The contact did not converge in " +
            std::to_string(rounds - 1) +
            " iterations. Increase Maximum iterations, or use smaller load steps.");
        if (!round.changed.empty())
          progress("  contact: " + std::to_string(round.active) +
                   " rows active, " + std::to_string(round.changed.size()) +
                   " change");
      });
    store_forces(rows, found, state);
    return found;
  }



  // H w by central differences of B^T lambda about u, with the truncation error
  // of second order in a step relative to the size of the scene.
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



  // Fixed-point form x = du + A x with A = K_c^-1 (H + S), K_c the tangent with
  // the active constraints fixed, solved by GMRES (Saad and Schultz, SIAM J.
  // Sci. Stat. Comput. 7 (1986) 856-869) only if A du is not negligible.
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
    // Slipping rows have the force direction n + mu e.
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
    const double enough = parameters.rotation_tolerance * du.l2_norm();
    // Tolerance relative to the correction, not to its rotation part.
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
    // Motions that only springs restrain keep their spring forces.
    if (structure.has_springs() &&
        length_of(x) > parameters.max_spring_influence * regularization_factor *
                         length_of(du))
      return du;
    // First-order update of forces; the next iteration finds the active set.
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



  // The Cholesky factor of the tangent of the last correction proves a minimum
  // of the energy; that of the end is formed only after a large correction.
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



  // With a shift, contact forces of active constraints become lambda + rho g
  // before the contact problem and return to lambda after it.
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
    BlockVector       du       = moved;
    bool              unstable = false;
    if (contacts.none())
      du += about.solve(r);
    else
      {
        const GapConstraints rows   = shift ? shift->rows() : contacts.rows();
        const double         closed = parameters.touching * structure.size();
        const auto           solver =
          strategy_at(strategy, about, rows, before, to, closed);
        // Gaps are linear in du, so states add up in the contact problem.
        if (shift)
          shift->remove_shift(sum_of(before, moved), to, state);
        state.u += du;
        const ContactSolution transfer =
          solve_contact(*solver, rows, r, to, state);
        du += transfer.du;
        unstable = transfer.is_unstable;
        if (shift)
          shift->apply_shift(sum_of(before, du), to, state);
        du = correct_row_rotation(
          *solver, before, du, regularization.regularization_factor, to, state);
      }
    shorten(du);
    state.u = structure.retract(before, du);
    // Springs contribute to K only; their offsets remove the force.
    if (structure.has_springs())
      state.rest = structure.spring_lengths(state.u);
    return {std::move(du), shift != nullptr, unstable};
  }
} // namespace lamella
