// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/solve/newton.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace lamella
{
  using namespace dealii;

  Newton::Newton(const Structure           &structure,
                 const std::vector<GapRow> &rows,
                 ContactStrategy           &strategy,
                 const NewtonParameters    &parameters)
    : progress([](const std::string &) {})
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
            r_lambda[i] = -(row.gap(state.u, factor) + lambda / row.penalty);
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



  std::vector<unsigned int>
  Newton::next_active_set(const State               &state,
                          const std::vector<double> &g,
                          const std::size_t          at_once) const
  {
    // Each change with what speaks for it: a penetration, or the gap that a
    // pulling force stands for. A gap that is only rounding does not close.
    const double      closed = 1e-14 * state.u.linfty_norm();
    std::vector<bool> is_active(rows.size(), false);
    for (const unsigned int r : state.active)
      is_active[r] = true;
    std::vector<std::pair<double, unsigned int>> to_open, to_close;
    for (unsigned int r = 0; r < rows.size(); ++r)
      if (is_active[r] && state.force[r] <= 0.)
        to_open.emplace_back(-state.force[r] / rows[r].penalty, r);
      else if (!is_active[r] && g[r] < -closed)
        to_close.emplace_back(-g[r], r);

    std::sort(to_close.rbegin(), to_close.rend());
    if (at_once == 1 && !to_open.empty())
      {
        // One change at a time, openings first.
        to_open = {*std::max_element(to_open.begin(), to_open.end())};
        to_close.clear();
      }
    to_close.resize(std::min(to_close.size(), at_once));
    for (const auto &[size, r] : to_open)
      is_active[r] = false;
    for (const auto &[size, r] : to_close)
      is_active[r] = true;

    std::vector<unsigned int> active;
    for (unsigned int r = 0; r < rows.size(); ++r)
      if (is_active[r])
        active.push_back(r);
    return active;
  }



  void
  Newton::solve_active(const State               &free,
                       const std::vector<double> &free_gaps,
                       State                     &state) const
  {
    // From the free state anew, so that no rounding adds up.
    Vector r_lambda(state.active.size()), lambda;
    for (unsigned int i = 0; i < state.active.size(); ++i)
      r_lambda[i] = -free_gaps[state.active[i]];
    BlockVector du;
    strategy.solve(state.active, nullptr, r_lambda, du, lambda);
    state.u = free.u;
    state.u += du;
    state.force.assign(rows.size(), 0.);
    for (unsigned int i = 0; i < state.active.size(); ++i)
      state.force[state.active[i]] = lambda[i];
  }



  State
  Newton::solve_contact(const State                     &free,
                        const double                     factor,
                        const std::vector<unsigned int> &start) const
  {
    const std::vector<double> free_gaps = gaps(free.u, factor);
    std::size_t               at_once   = parameters.rows_at_once;

    // Of the rows to start from those that would be open without any contact
    // are left out: in unloading they pull, and pull others in.
    State state = free;
    for (const unsigned int r : start)
      if (free_gaps[r] < 0.)
        state.active.push_back(r);
    if (state.active.empty())
      state.active = next_active_set(state, free_gaps, at_once);

    // Where the matrix has lost digits the active set is decided on refined
    // states; elsewhere it is enough that the last one is.
    const bool lost_digits =
      !free.free_corrections.empty() && free.free_corrections.front() > 1e-10;
    std::set<std::vector<unsigned int>> visited;
    while (!state.active.empty() || state.iterations > 0)
      {
        ++state.iterations;
        visited.insert(state.active);
        solve_active(free, free_gaps, state);
        if (lost_digits)
          state.contact_corrections = refine(state, factor, 1);
        std::vector<unsigned int> next =
          next_active_set(state, gaps(state.u, factor), at_once);
        if (next == state.active && !lost_digits)
          {
            state.contact_corrections = refine(state, factor, 1);
            next = next_active_set(state, gaps(state.u, factor), at_once);
          }

        std::vector<unsigned int> changed;
        std::set_symmetric_difference(next.begin(),
                                      next.end(),
                                      state.active.begin(),
                                      state.active.end(),
                                      std::back_inserter(changed));
        progress("iteration " + std::to_string(state.iterations) + ": " +
                 std::to_string(state.active.size()) + " active rows, " +
                 std::to_string(changed.size()) + " change");
        if (changed.empty())
          break;
        // A set that comes back would come back for ever: from then on one row
        // changes at a time.
        at_once =
          visited.count(next) > 0 ?
            1 :
            std::max<std::size_t>(at_once, at_once > 1 ? next.size() : 1);
        if (state.iterations >= parameters.max_iterations)
          throw NumericsError(
            "The contact did not settle in " +
            std::to_string(parameters.max_iterations) + " iterations; " +
            std::to_string(changed.size()) + " of " +
            std::to_string(rows.size()) +
            " rows keep changing. Try a softer penalty, the condensed strategy, "
            "a finer mesh at the edge of the contact, or more Maximum "
            "iterations.");
        state.active = next;
      }
    return state;
  }
} // namespace lamella
