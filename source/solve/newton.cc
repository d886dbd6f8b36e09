// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/solve/newton.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamella
{
  using namespace dealii;

  Newton::Newton(const Structure           &structure,
                 const std::vector<GapRow> &rows,
                 ContactStrategy           &strategy,
                 const NewtonParameters    &parameters)
    : progress([](const std::string &) {})
    , describe(
        [](const unsigned int row) { return "row " + std::to_string(row); })
    , structure(structure)
    , rows(rows)
    , strategy(strategy)
    , parameters(parameters)
  {}



  std::vector<double>
  Newton::gaps(const BlockVector &u, const double factor) const
  {
    std::vector<double> g;
    for (const GapRow &row : rows)
      g.push_back(row.gap(u, factor));
    return g;
  }



  State
  Newton::solve_free(const double factor) const
  {
    State state;
    state.u = structure.particular(factor);
    state.force.assign(rows.size(), 0.);
    // The first correction is the solution itself, the second a refinement.
    state.free_corrections = refine(state, factor, 2);
    state.free_corrections.erase(state.free_corrections.begin());
    return state;
  }



  std::vector<double>
  Newton::refine(State             &state,
                 const double       factor,
                 const unsigned int at_least) const
  {
    std::vector<double> corrections;
    for (unsigned int k = 0; k < parameters.max_refinements + at_least; ++k)
      {
        BlockVector r_u = structure.residual(state.u, factor);
        Vector      r_lambda(state.active.size());
        for (unsigned int i = 0; i < state.active.size(); ++i)
          {
            const GapRow &row    = rows[state.active[i]];
            const double  lambda = state.force[state.active[i]];
            row.add_to(r_u, lambda);
            r_lambda[i] =
              -(row.gap(state.u, factor) + law_softness(row) * lambda);
          }

        BlockVector du;
        Vector      dlambda;
        strategy.solve(state.active, &r_u, r_lambda, du, dlambda);
        state.u += du;
        for (unsigned int i = 0; i < state.active.size(); ++i)
          state.force[state.active[i]] += dlambda[i];

        // Written so that what is not a number stays none.
        const double size = state.u.linfty_norm(), change = du.l2_norm();
        corrections.push_back(change == 0. ? 0. : du.linfty_norm() / size);
        if (!std::isfinite(change))
          throw NumericsError(
            "The solution is not a finite number. Check the loads, and "
            "whether the stiffnesses are beyond what double precision holds.");
        // Done, or down to the rounding of the residual itself.
        const unsigned int n = corrections.size();
        if (n >= at_least &&
            (corrections.back() < parameters.refinement_tolerance ||
             (n > at_least && corrections[n - 1] > 0.5 * corrections[n - 2])))
          break;
      }
    return corrections;
  }



  ContactProblem
  Newton::first_problem(const std::vector<double> &free_gaps,
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



  Newton::Misses
  Newton::misses(const State               &state,
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



  void
  Newton::watch(const Round &round, unsigned int &iterations) const
  {
    ++iterations;
    progress("iteration " + std::to_string(iterations) + ": " +
             std::to_string(round.active) + " active rows, " +
             std::to_string(round.changed.size()) + " to change" +
             (round.changed.empty() ?
                "" :
                ", gaps off by up to " + to_text(round.violation, 3)));
    if (!round.changed.empty())
      check_iterations(iterations, round.changed);
  }



  void
  Newton::check_iterations(const unsigned int               iterations,
                           const std::vector<unsigned int> &changing) const
  {
    if (iterations < parameters.max_iterations)
      return;
    std::string names;
    for (unsigned int k = 0; k < changing.size() && k < 3; ++k)
      names += (k > 0 ? "; " : "") + describe(changing[k]);
    throw NumericsError(
      "The contact did not settle in " +
      std::to_string(parameters.max_iterations) + " iterations; " +
      std::to_string(changing.size()) + " of " + std::to_string(rows.size()) +
      " rows keep changing" + (names.empty() ? "" : " (" + names) +
      (names.empty()       ? "" :
       changing.size() > 3 ? "; ...)" :
                             ")") +
      ". Try a softer penalty, the condensed strategy, a finer mesh at the "
      "edge of the contact, or more Maximum iterations.");
  }



  State
  Newton::solve_contact(const State &free,
                        const double factor,
                        const State &previous) const
  {
    // Relative to the displacements: what gaps are accurate to, and what is
    // good enough for rows that rounding does not let close any further.
    constexpr double accurate = 1e-12, acceptable = 1e-10;

    State          state   = free;
    ContactProblem problem = first_problem(gaps(free.u, factor), previous);
    double         before  = std::numeric_limits<double>::max();
    while (true)
      {
        problem.closed = 1e-14 * state.u.linfty_norm();
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

        const double size = state.u.linfty_norm();
        problem.closed =
          size * std::max(1e-14, state.contact_corrections.back());
        problem.gap        = gaps(state.u, factor);
        const Misses found = misses(state, problem.gap, problem.closed);
        const bool   right = found.opening.empty() && found.closing.empty();
        const bool   slow  = found.gap > 0.1 * before;
        if (right && (found.gap <= accurate * size ||
                      (slow && found.gap <= acceptable * size)))
          return state;

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
        std::vector<unsigned int> changing = found.opening;
        changing.insert(changing.end(),
                        found.closing.begin(),
                        found.closing.end());
        check_iterations(state.iterations, changing);
        if (slow)
          strategy.stiffen();
        before           = found.gap;
        problem.estimate = problem.force = state.force;
        problem.start                    = state.active;
      }
  }
} // namespace lamella
