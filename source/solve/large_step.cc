// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/solve/large_step.h>
#include <lamella/solve/phase.h>
#include <lamella/solve/solution_check.h>

#include <algorithm>

// A load step at finite rotations: NonlinearSolver::advance() from the previous
// state, then checks in the current configuration. Results of a restart are
// bitwise equal, since the pairing is part of the state (ContactHistory).
namespace lamella
{
  using dealii::TimerOutput;

  LargeStep::LargeStep(const Structure                    &structure,
                       const MovingContacts               &contacts,
                       const unsigned int                  n_supports,
                       const SolveParameters              &parameters,
                       const NonlinearSolver::Progress    &progress,
                       const TangentOperator::BodyMonitor &monitor,
                       TimerOutput                        &timer)
    : structure(structure)
    , solver(structure,
             contacts,
             parameters.solver,
             parameters.nonlinear,
             parameters.strategy)
    , n_supports(n_supports)
    , parameters(parameters)
    , timer(timer)
  {
    solver.progress = progress;
    solver.monitor  = monitor;
  }



  SolvedStep
  LargeStep::operator()(const State      &before,
                        const LoadFactor &from,
                        const LoadFactor &to,
                        const bool        last)
  {
    SolvedStep solved;
    solved.load_factor = to;
    {
      TimerOutput::Scope scope(timer, name_of(Phase::solve));
      const Equilibrium  start = make_start(before, from, to);
      // Rows belong to no state during the iterations.
      reached         = BlockVector();
      Equilibrium end = solver.advance(start, to);
      solved.state    = std::move(end.state);
      reached         = solved.state.u;
      // The iterations end at the rounding of the largest displacement.
      constexpr double digits = 100.;
      for (unsigned int b = 0; b < solved.state.u.n_blocks(); ++b)
        {
          double size = digits * solved.state.u.block(b).linfty_norm();
          // Forces between bodies have the rounding of their displacement.
          size = std::max(size, end.rounding / arithmetic::rounding);
          solved.state.free_sizes.push_back(
            before.free_sizes.empty() ? size :
                                        std::max(size, before.free_sizes[b]));
        }
      solved.cuts           = end.cuts;
      solved.state.pairings = solver.moving().memory();
    }
    solved.checks = check(solved.state, to, last);
    return solved;
  }



  // Restores the pairings of another run, which its state contains.
  void
  LargeStep::resume_from(const State &last, const LoadFactor &factor)
  {
    solver.restore(last, factor);
    reached = last.u;
  }



  // A state from another path (a branch or a bisection) first restores the
  // contacts, whose rows belong to the last state reached.
  Equilibrium
  LargeStep::make_start(const State      &before,
                        const LoadFactor &from,
                        const LoadFactor &to)
  {
    if (before.u.n_blocks() == 0)
      return solver.unloaded(to);
    if (reached.n_blocks() == 0 || !(before.u == reached))
      solver.restore(before, from);
    Equilibrium start;
    start.state  = before;
    start.factor = from;
    start.state.free_sizes.clear();
    start.state.pairings.clear();
    return start;
  }



  // Equilibrium, energy and contact law at current positions, then the supports
  // that no correction follows (check_followed()).
  Checks
  LargeStep::check(const State &state, const LoadFactor &factor, const bool)
  {
    TimerOutput::Scope    scope(timer, name_of(Phase::solve));
    const TangentOperator here(structure, state.u);
    Checks                checks = check_state(
      here, solver.moving().interfaces(), n_supports, state, factor);
    check_solution(state, checks, parameters.rotation_limit);
    check_followed(here, factor);
    return checks;
  }
} // namespace lamella
