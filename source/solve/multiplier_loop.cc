// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/solve/multiplier_loop.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    std::vector<unsigned int>
    united(std::vector<unsigned int> a, const std::vector<unsigned int> &b)
    {
      a.insert(a.end(), b.begin(), b.end());
      return a;
    }
  } // namespace



  MultiplierLoop::MultiplierLoop(std::shared_ptr<const Linearisation> about,
                                 const GapRows                       &rows,
                                 const SolverParameters &parameters)
    : ContactSolver(std::move(about), rows, parameters)
    , strategy(*linearisation, rows)
  {}



  ContactProblem
  MultiplierLoop::first_problem(const std::vector<double> &free_gaps,
                                const State               &previous) const
  {
    // Rows that would be open without any contact start open: in unloading they
    // pull, and pull others in.
    ContactProblem problem;
    problem.gap = free_gaps;
    problem.force.assign(rows.size(), 0.);
    problem.estimate.assign(rows.size(), 0.);
    for (const unsigned int r : previous.active)
      if (free_gaps[r] < 0.)
        {
          problem.start.push_back(r);
          problem.estimate[r] = previous.force[r];
        }
    return problem;
  }



  MultiplierLoop::Misses
  MultiplierLoop::misses(const State               &state,
                         const std::vector<double> &g,
                         const double               closed) const
  {
    Misses found;
    for (const unsigned int r : state.active)
      if (state.force[r] < 0.)
        found.opening.push_back(r);
      else
        found.gap =
          std::max(found.gap,
                   std::abs(g[r] + law_softness(rows[r]) * state.force[r]));
    for (unsigned int r = 0; r < rows.size(); ++r)
      if (g[r] < -closed &&
          !std::binary_search(state.active.begin(), state.active.end(), r))
        found.closing.push_back(r);
    return found;
  }



  bool
  MultiplierLoop::correct_set(State &state, const double factor)
  {
    constexpr unsigned int most_rounds = 20;
    constexpr double       acceptable  = 1e-10;
    for (unsigned int round = 0; round < most_rounds; ++round)
      {
        const double size = size_of(state, factor);
        const double closed =
          size * std::max(1e-14, state.contact_corrections.back());
        const Misses found = misses(state, gaps(state.u, factor), closed);
        if (found.opening.empty() && found.closing.empty())
          return found.gap <= acceptable * size;
        for (const unsigned int r : found.opening)
          state.force[r] = 0.;
        std::vector<unsigned int> staying;
        std::set_difference(state.active.begin(),
                            state.active.end(),
                            found.opening.begin(),
                            found.opening.end(),
                            std::back_inserter(staying));
        state.active = united(std::move(staying), found.closing);
        std::sort(state.active.begin(), state.active.end());
        ++state.iterations;
        state.contact_corrections = refine(state, factor, 1);
      }
    return false;
  }



  State
  MultiplierLoop::solve_contact(const State &free,
                                const double factor,
                                const State &previous)
  {
    // Relative to the displacements: what gaps are accurate to, and what is
    // good enough for rows that rounding does not let close any further.
    constexpr double accurate = 1e-12, acceptable = 1e-10;

    State          state   = free;
    ContactProblem problem = first_problem(gaps(free.u, factor), previous);
    double         before  = std::numeric_limits<double>::max();
    std::vector<unsigned int> last;
    while (true)
      {
        problem.closed = 1e-14 * size_of(state, factor);
        const ContactSolution contact =
          strategy.settle(problem, [&](const Round &round) {
            watch(round, state.iterations);
          });
        if (state.iterations == 0)
          return state;
        state.u += contact.du;
        state.force               = contact.force;
        state.active              = contact.active;
        State settled             = state;
        state.contact_corrections = refine(state, factor, 1);

        const double size = size_of(state, factor);
        problem.closed =
          size * std::max(1e-14, state.contact_corrections.back());
        problem.gap        = gaps(state.u, factor);
        const Misses found = misses(state, problem.gap, problem.closed);
        const bool   right = found.opening.empty() && found.closing.empty();
        const bool   slow  = found.gap > 0.1 * before;
        if (right && (found.gap <= accurate * size ||
                      (slow && found.gap <= acceptable * size)))
          return state;

        if (!right && contact.active == last)
          {
            State corrected = state;
            if (correct_set(corrected, factor))
              return corrected;
          }
        last = contact.active;
        if (!right)
          {
            // Only the strategy's forces are sure to push: with them alone the
            // next round starts, if the state that they cause is not good
            // enough as it is. It is where rows depend on each other and
            // rounding moves forces among them, also below zero.
            settled.active.clear();
            settled.contact_corrections = refine(settled, factor, 1);
            settled.active              = contact.active;
            state                       = std::move(settled);
            problem.gap                 = gaps(state.u, factor);
            const Misses left = misses(state, problem.gap, acceptable * size);
            if (left.closing.empty() && left.gap <= acceptable * size)
              return state;
          }
        check_iterations(state.iterations,
                         united(found.opening, found.closing));
        if (slow)
          strategy.numerical_softness.stiffen();
        before           = found.gap;
        problem.estimate = problem.force = state.force;
        problem.start                    = state.active;
      }
  }
} // namespace lamella
