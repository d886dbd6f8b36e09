// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/solve/newton.h>

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
  Newton::release_springs(State state, const double factor) const
  {
    constexpr unsigned int most_rounds = 60;
    // Of the displacements, what the springs' rest still moves by; of loads and
    // contact forces, what springs still carry. (A motion that nothing loads
    // nor holds drifts by rounding, without a force to speak of.)
    constexpr double at_rest = 1e-12, without_force = 1e-13;

    if (!structure.has_springs())
      return state;
    double before = std::numeric_limits<double>::max();
    for (unsigned int round = 1;; ++round)
      {
        const SpringRest rest   = structure.spring_lengths(state.u);
        double           change = 0., force = 0.;
        for (unsigned int b = 0; b < rest.size(); ++b)
          for (unsigned int k = 0; k < rest[b].size(); ++k)
            {
              const double moved = std::abs(
                rest[b][k] - (state.rest.empty() ? 0. : state.rest[b][k]));
              change = std::max(change, moved);
              force =
                std::max(force, structure.springs(b)[k].stiffness * moved);
            }
        double forces = std::abs(factor) * structure.load().linfty_norm();
        for (const double lambda : state.force)
          forces = std::max(forces, std::abs(lambda));
        if (change <= at_rest * size_of(state, factor) ||
            force <= without_force * forces)
          return state;
        if (round > most_rounds)
          fail_on_springs(state, change / before);
        before     = change;
        State next = solve_contact(solve_free(factor, rest), factor, state);
        next.iterations += state.iterations;
        state = std::move(next);
      }
  }



  void
  Newton::fail_on_springs(const State &state, const double rate) const
  {
    constexpr double wanted_rate = 0.1;

    // Whose spring is still under the largest force.
    const SpringRest lengths = structure.spring_lengths(state.u);
    unsigned int     body = 0, spring = 0;
    double           largest = -1.;
    for (unsigned int b = 0; b < lengths.size(); ++b)
      for (unsigned int k = 0; k < lengths[b].size(); ++k)
        {
          const double force = structure.springs(b)[k].stiffness *
                               std::abs(lengths[b][k] - state.rest[b][k]);
          if (force > largest)
            {
              largest = force;
              body    = b;
              spring  = k;
            }
        }
    const Spring     &worst = structure.springs(body)[spring];
    const std::string name  = structure.bodies()[body]->name();
    if (!(rate < 0.999))
      throw NumericsError(
        "Body '" + name +
        "' is not held by its contacts: its loads move it on "
        "and on (" +
        worst.motion +
        "), against nothing but its stabilising springs. Add a support, close "
        "its gaps by a prescribed displacement, or load it towards the body "
        "that is to hold it.");
    throw NumericsError("The stabilising springs of body '" + name +
                        "' are too stiff beside the contacts that hold it (" +
                        worst.motion + "): their share falls by the factor " +
                        to_text(rate, 3) + " a round only. Take Body " + name +
                        "/Stabilisation = " +
                        to_text(worst.share * wanted_rate / (1. - wanted_rate) *
                                  (1. - rate) / rate,
                                1) +
                        ".");
  }



  double
  Newton::size_of(const State &state, const double factor) const
  {
    // Gaps are differences of displacements and of the way of obstacles.
    double size = state.u.linfty_norm();
    for (const GapRow &row : rows)
      size = std::max(size, std::abs(factor * row.gap_rate));
    return size;
  }



  State
  Newton::solve_free(const double factor, const SpringRest &rest) const
  {
    State state;
    state.rest = rest;
    state.u    = structure.particular(factor);
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
        BlockVector r_u = structure.residual(state.u, factor, state.rest);
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



  bool
  Newton::correct_set(State &state, const double factor) const
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
      ". Try " + strategy.remedy() +
      ", a finer mesh at the edge of the contact, or more Maximum iterations.");
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
          strategy.stiffen();
        before           = found.gap;
        problem.estimate = problem.force = state.force;
        problem.start                    = state.active;
      }
  }
} // namespace lamella
