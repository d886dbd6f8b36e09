// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/solve/newton.h>

#include <algorithm>

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
  Newton::gaps(const BlockVector &u) const
  {
    std::vector<double> g;
    for (const GapRow &row : rows)
      g.push_back(row.gap(u));
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
            r_lambda[i] = -(row.gap(state.u) + lambda / row.penalty);
          }

        BlockVector du;
        Vector      dlambda;
        strategy.solve(state.active, &r_u, r_lambda, du, dlambda);
        state.u += du;
        for (unsigned int i = 0; i < state.active.size(); ++i)
          state.force[state.active[i]] += dlambda[i];

        const double size = state.u.linfty_norm();
        corrections.push_back(size > 0. ? du.linfty_norm() / size : 0.);
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
                          const std::vector<double> &g) const
  {
    std::vector<bool> is_active(rows.size(), false);
    for (const unsigned int r : state.active)
      is_active[r] = state.force[r] > 0.;

    // A gap that is only rounding does not close.
    const double              closed = -1e-14 * state.u.linfty_norm();
    std::vector<unsigned int> violators;
    for (unsigned int r = 0; r < rows.size(); ++r)
      if (!is_active[r] && g[r] < closed)
        violators.push_back(r);
    std::sort(violators.begin(), violators.end(), [&g](auto a, auto b) {
      return g[a] < g[b];
    });
    const std::size_t at_once =
      std::max<std::size_t>(parameters.rows_at_once, state.active.size());
    violators.resize(std::min(violators.size(), at_once));
    for (const unsigned int r : violators)
      is_active[r] = true;

    std::vector<unsigned int> active;
    for (unsigned int r = 0; r < rows.size(); ++r)
      if (is_active[r])
        active.push_back(r);
    return active;
  }



  State
  Newton::solve_contact(const State                     &free,
                        const double                     factor,
                        const std::vector<unsigned int> &start) const
  {
    const std::vector<double> free_gaps = gaps(free.u);

    // Of the rows to start from those that would be open without any contact
    // are left out: in unloading they pull, and pull others in.
    State state = free;
    for (const unsigned int r : start)
      if (free_gaps[r] < 0.)
        state.active.push_back(r);
    if (state.active.empty())
      state.active = next_active_set(state, free_gaps);
    if (state.active.empty())
      return state;

    std::vector<unsigned int> next;
    for (state.iterations = 1;; ++state.iterations)
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

        next = next_active_set(state, gaps(state.u));
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
        if (state.iterations == parameters.max_iterations)
          throw NumericsError(
            "The contact did not settle in " +
            std::to_string(parameters.max_iterations) + " iterations; " +
            std::to_string(changed.size()) + " of " +
            std::to_string(rows.size()) +
            " rows keep changing. Try smaller load steps, a softer penalty or "
            "a finer mesh at the edge of the contact.");
        state.active = next;
      }
    state.contact_corrections = refine(state, factor, 1);
    return state;
  }
} // namespace lamella
