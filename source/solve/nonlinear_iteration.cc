// SPDX-License-Identifier: LGPL-2.1-or-later

// One iteration of Newton's method with contact. About the state u:
// 1. factorize the tangent K (nonlinear_springs.cc regularizes it if needed);
//    keep that of the last iteration if one more correction should suffice;
// 2. du = K^-1 r + support motion, without a change of contact forces;
// 3. solve the contact problem of the linearized gaps g + B du for forces and
//    active set by static condensation (Wriggers, Computational Contact
//    Mechanics, Springer 2006, Ch. 10; CondensedStrategy);
// 4. correct du for the rotation of the normals, H = sum lambda Hess g, by
//    GMRES preconditioned with the solution of step 3;
// 5. update the state multiplicatively, u <- retract(u, du).

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/solve/contact_strategy.h>
#include <lamella/solve/friction_step.h>
#include <lamella/solve/nonlinear_solver.h>

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_gmres.h>

#include <algorithm>
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



    /// Number of gaps and slips with friction of the active @p rows of @p
    /// state; without any, of those with gaps of at most @p closed.
    double
    n_in_contact(const GapConstraints &rows,
                 const State          &state,
                 const LoadFactor     &to,
                 const double          closed)
    {
      double n = 0.;
      for (unsigned int r = 0; r < rows.size(); ++r)
        if (state.active.empty() ?
              rows[r].gap(state.u, to) <= closed :
              std::binary_search(state.active.begin(), state.active.end(), r))
          n += rows[r].slips.empty() ? 0. : 1. + rows[r].slips.size();
      return n;
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
  ContactProblem
  NonlinearSolver::problem_at(const GapConstraints &rows,
                              const BlockVector    &r,
                              const LoadFactor     &to,
                              const State          &state) const
  {
    ContactProblem problem;
    problem.residual = r;
    for (const GapConstraint &row : rows)
      problem.gap.push_back(row.gap(state.u, to));
    problem.force = problem.estimate = state.force;
    problem.start                    = rows.with_ties(state.active);
    problem.closed                   = rounding_of_gaps(state, to);
    if (!state.friction.empty())
      add_friction(rows, state, to, problem);
    return problem;
  }



  ContactSolution
  NonlinearSolver::solve_contact(ContactStrategy      &strategy,
                                 const GapConstraints &rows,
                                 const ContactProblem &problem,
                                 State                &state) const
  {
    ContactSolution found = strategy.solve(
      problem,
      [this, &strategy, &state, rounds = 0u](const Round &round) mutable {
        state.iterations += linear != nullptr ? 1 : 0;
        if (round.changed.empty())
          return;
        progress("  contact: " + std::to_string(round.active) +
                 " rows active, " + std::to_string(round.changed.size()) +
                 " change, gaps off by up to " + to_text(round.violation, 3));
        if (round.counts)
          check_rounds(strategy, ++rounds, round.changed);
      });
    for (unsigned int k = 0; k < found.solved_by.size(); ++k)
      state.solved_by[k] += found.solved_by[k];
    store_forces(rows, found, state);
    return found;
  }



  // H w by central differences of B^T lambda about u, with the truncation error
  // of second order in a step relative to the size of the scene.
  BlockVector
  NonlinearSolver::rotation_of_constraints(const State       &state,
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
  NonlinearSolver::correct_row_rotation(ContactStrategy   &strategy,
                                        const BlockVector &u,
                                        const BlockVector &du,
                                        const double      regularization_factor,
                                        const LoadFactor &to,
                                        State            &state) const
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
      for (unsigned int b = 0; b < structure.bodies().size(); ++b)
        for (const auto &[row, stiffness] : structure.spring_terms(b))
          row.add_to(f.block(b),
                     regularization_factor * stiffness * row(w.block(b)));
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
      if (state.force[row] < 0. && !contacts.rows()[row].is_tied())
        {
          state.force[row] = 0.;
          if (!state.friction.empty())
            state.friction.shear[row] = dealii::Tensor<1, 3>();
        }
    return x;
  }



  // The Cholesky factor of the last tangent proves a minimum of the energy;
  // that of the end is formed only if it is far away.
  void
  NonlinearSolver::check_stability(const BlockVector  &before,
                                   RegularizedTangent &about,
                                   const Correction   &last,
                                   const State        &state,
                                   const LoadFactor   &to) const
  {
    if (last.is_unstable)
      throw NumericsError(
        std::string("solve.friction-unstable: The equilibrium with friction is "
                    "unstable: bodies that touch at their ends jam") +
        friction_remedy);
    if (linear != nullptr)
      return;
    BlockVector way = state.u, from_tangent = state.u;
    way -= before;
    from_tangent -= about.K->displacements();
    const bool is_near =
      about.shift == nullptr &&
      length_of(from_tangent) <= parameters.converged_step * length_of(way);
    if (is_near && !structure.has_springs())
      return;
    // Frees the memory of its factor for another one.
    about = RegularizedTangent();
    if (!(structure.has_springs() && check_supports(state, to)) && !is_near)
      tangent(state, BlockVector(), to);
  }



  // With a shift, contact forces of active constraints become lambda + rho g
  // before the contact problem and return to lambda after it.
  NonlinearSolver::Correction
  NonlinearSolver::correct(const RegularizedTangent &about,
                           const BlockVector        &r,
                           const BlockVector        &moved,
                           const LoadFactor         &to,
                           State                    &state) const
  {
    const auto       &shift    = about.shift;
    const BlockVector before   = state.u;
    BlockVector       du       = moved;
    bool              unstable = false;
    if (contacts.none())
      du += about.K->solve(r);
    else
      {
        const GapConstraints rows = shift ? shift->rows() : contacts.rows();
        const double         n =
          n_in_contact(rows, state, to, rounding_of_gaps(state, to));
        const auto solver =
          make_strategy(choose_strategy(strategy, structure, n),
                        *about.K,
                        rows);
        // Gaps are linear in du, so states add up in the contact problem.
        if (shift)
          shift->remove_shift(sum_of(before, moved), to, state);
        state.u += du;
        const ContactSolution transfer =
          solve_contact(*solver, rows, problem_at(rows, r, to, state), state);
        du += transfer.du;
        unstable = transfer.is_unstable;
        if (shift)
          shift->apply_shift(sum_of(before, du), to, state);
        du = correct_row_rotation(
          *solver, before, du, about.regularization_factor, to, state);
      }
    shorten(du);
    state.u = structure.retract(before, du);
    // Springs contribute to K only; their offsets remove the force.
    if (structure.has_springs())
      state.rest = structure.spring_lengths(state.u);
    return {std::move(du), unstable};
  }



  // The first problem is about the state without contact, which has no
  // unbalanced forces. Its rows start open, as in unloading they become tensile
  // and activate others; those that penetrate take the forces of the estimate.
  NonlinearSolver::Correction
  NonlinearSolver::correct_linear(const BlockVector &r,
                                  const LoadFactor  &to,
                                  const State       &estimate,
                                  State             &state) const
  {
    const GapConstraints &rows    = contacts.rows();
    ContactProblem        problem = problem_at(rows, r, to, state);
    if (estimate.u.n_blocks() > 0)
      {
        problem.start = rows.with_ties({});
        for (const unsigned int row : rows.with_ties(estimate.active))
          if (problem.gap[row] < 0. || rows[row].is_tied())
            {
              if (!rows[row].is_tied())
                problem.start.push_back(row);
              problem.estimate[row] = estimate.force[row];
            }
        std::sort(problem.start.begin(), problem.start.end());
        if (!estimate.friction.empty())
          problem.first_forces = forces_by_rows(rows, estimate);
      }
    BlockVector           du = state.u;
    const ContactSolution transfer =
      solve_contact(linear->contact_strategy(), rows, problem, state);
    state.u += transfer.du;
    linear->refine_contact(state, to);
    du -= state.u;
    du *= -1.;
    const SpringRelease released = spring_motion(state, to);
    if (!released.is_done)
      {
        progress("  stabilizing springs released: bodies move by up to " +
                 to_text(released.length, 2));
        state.rest = structure.spring_lengths(state.u);
      }
    return {std::move(du), transfer.is_unstable, released};
  }
} // namespace lamella
