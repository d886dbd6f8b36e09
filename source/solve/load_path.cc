// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/beyond_linear.h>
#include <lamella/solve/load_path.h>
#include <lamella/solve/phase.h>
#include <lamella/solve/soundness.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using dealii::TimerOutput;

  Step::Step(ContactSolver                       &solver,
             const std::vector<ContactInterface> &contacts,
             const Contacts                      &lives,
             const unsigned int                   n_supports,
             const SolveParameters               &parameters,
             TimerOutput                         &timer)
    : solver(solver)
    , structure(solver.tangent().of())
    , contacts(contacts)
    , lives(lives)
    , rows(contacts)
    , n_supports(n_supports)
    , parameters(parameters)
    , timer(timer)
  {}



  SolvedStep
  Step::operator()(const State &before, const LoadFactor &factor) const
  {
    SolvedStep solved;
    solved.load_factor = factor;
    {
      TimerOutput::Scope scope(timer, name_of(Phase::solve));
      solved.state = solver.solve_free(factor);
    }
    if (!rows.empty())
      {
        TimerOutput::Scope scope(timer, name_of(Phase::contact));
        solved.state = solver.release_springs(
          solver.solve_contact(solved.state, factor, before), factor);
        solver.end_step(before, factor, solved.state);
      }
    solved.checks = check(solved.state, factor);
    return solved;
  }



  Checks
  Step::check(const State &state, const LoadFactor &factor) const
  {
    Checks checks;
    {
      TimerOutput::Scope scope(timer, name_of(Phase::solve));
      checks =
        check_state(solver.tangent(), contacts, n_supports, state, factor);
      require_sound(state, checks, parameters.rotation_limit);
      for (unsigned int k = 0; k < contacts.size(); ++k)
        lives[k]->require_found(state.u,
                                factor,
                                rows.among_contact(k, state.active));
    }
    if (!parameters.is_judged)
      return checks;
    {
      TimerOutput::Scope scope(timer, name_of(Phase::beyond));
      checks.beyond = beyond_linear(structure, solver, state, checks.energies);
    }
    if (parameters.beyond_linear == OutOfRange::refuse)
      require_linear_range(checks.beyond, structure);
    return checks;
  }



  LoadPath::LoadPath(const Step                    &step,
                     const std::vector<LoadFactor> &factors,
                     const bool                     branches)
    : step(step)
    , factors(factors)
    , branches(branches)
  {}



  void
  LoadPath::resume(const unsigned int n_done, State state)
  {
    AssertIndexRange(n_done - 1, factors.size());
    done = n_done;
    last = std::move(state);
    store(factors[done - 1].of_scene(), last);
  }



  SolvedStep
  LoadPath::advance()
  {
    SolvedStep solved = step(last, factors[done]);
    last              = solved.state;
    store(factors[done].of_scene(), last);
    ++done;
    return solved;
  }



  SolvedStep
  LoadPath::branch(const double factor)
  {
    // Of two that are as near the newer one: its rows are known.
    const State *from    = nullptr;
    double       nearest = 0.;
    for (const auto &[at, state] : stored)
      if (from == nullptr || std::abs(at - factor) <= nearest)
        {
          from    = &state;
          nearest = std::abs(at - factor);
        }
    SolvedStep solved = step(from == nullptr ? State() : *from, factor);
    store(factor, solved.state);
    return solved;
  }



  void
  LoadPath::store(const double factor, const State &state)
  {
    const auto is_here = [factor](const auto &known) {
      return known.first == factor;
    };
    if (branches && std::none_of(stored.begin(), stored.end(), is_here))
      stored.emplace_back(factor, state);
  }
} // namespace lamella
