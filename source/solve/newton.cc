// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/solve/newton.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamella
{
  Newton::Newton(const Structure        &structure,
                 const SolverKind        asked,
                 const NewtonParameters &parameters)
    : structure(structure)
    , asked(asked)
    , parameters(parameters)
  {
    if (structure.is_heated() || structure.has_springs())
      throw InputError("Large rotations know neither Temperature nor "
                       "Stabilisation yet: take a Support in place of it.");
  }



  Equilibrium
  Newton::at_rest(const LoadFactor &factor) const
  {
    Equilibrium state;
    state.u      = structure.zero();
    state.factor = factor.without_loads();
    return state;
  }



  std::optional<double>
  Newton::share_left(const BlockVector &r,
                     const LoadFactor  &factor,
                     const double       began) const
  {
    const BlockVector load     = structure.load(factor);
    BlockVector       internal = load, left = r;
    internal -= r;
    structure.condense(left);
    const double norm = left.l2_norm();
    // Written so that what is not a number is nothing.
    if (!(norm <= parameters.diverged * began))
      return std::nullopt;
    return norm <= parameters.nothing * began ?
             0. :
             norm / std::max(internal.l2_norm(), load.l2_norm());
  }



  bool
  Newton::is_equilibrium(const double left,
                         const double before,
                         const double change) const
  {
    return left <= parameters.balanced ||
           (left < parameters.floor && left > parameters.stalls * before) ||
           (left < parameters.near &&
            change < parameters.still * structure.size());
  }



  bool
  Newton::step(const LoadFactor &to,
               const bool        predicted,
               Equilibrium      &state) const
  {
    BlockVector moved = structure.particular(to), correction;
    moved -= structure.particular(state.factor);
    BlockVector r = structure.residual(state.u, to);
    if (moved.l2_norm() > 0.)
      r -= Linearisation(structure, state.u).apply(moved);
    const double began  = r.l2_norm();
    double       before = std::numeric_limits<double>::max();
    for (unsigned int k = 0; k < parameters.max_iterations; ++k)
      {
        ++state.iterations;
        correction = Linearisation(structure,
                                   state.u,
                                   asked,
                                   {},
                                   predicted ? correction : BlockVector())
                       .solve(r);
        if (k == 0)
          correction += moved;
        state.u += correction;

        r               = structure.residual(state.u, to);
        const auto left = share_left(r, to, began);
        if (!left)
          return false;
        if (is_equilibrium(*left, before, correction.linfty_norm()))
          {
            state.factor   = to;
            state.residual = *left;
            return true;
          }
        before = *left;
      }
    return false;
  }



  bool
  Newton::attempt(const LoadFactor &to, Equilibrium &state) const
  {
    const Equilibrium before     = state;
    unsigned int      iterations = state.iterations;
    for (const bool predicted : {true, false})
      {
        state            = before;
        state.iterations = iterations;
        try
          {
            if (step(to, predicted, state))
              return true;
          }
        catch (const NumericsError &)
          {}
        iterations = state.iterations;
      }
    state            = before;
    state.iterations = iterations;
    return false;
  }



  Equilibrium
  Newton::advance(const Equilibrium &start, const LoadFactor &to) const
  {
    Equilibrium state = start;
    state.iterations = state.cuts = 0;
    // How far it is, and how far the next step is to go.
    double done = 0., way = 1.;
    while (done < 1.)
      {
        const double     next   = std::min(1., done + way);
        const LoadFactor target = next < 1. ? to.after(start.factor, next) : to;
        if (attempt(target, state))
          {
            done = next;
            continue;
          }
        way /= 2.;
        if (++state.cuts > parameters.max_cuts)
          throw NumericsError(
            "No equilibrium was found beyond the share " + to_text(done, 4) +
            " of the way to load factor " + to_text(to.of_scene()) +
            ": the loads may pass a limit there. Prescribe a displacement in "
            "place of them.");
      }
    return state;
  }
} // namespace lamella
