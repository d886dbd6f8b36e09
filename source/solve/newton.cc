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



  Newton::Left
  Newton::left_of(const BlockVector &u, const LoadFactor &factor) const
  {
    const BlockVector internal = structure.internal_forces(u),
                      load     = structure.load(factor);
    BlockVector left           = load;
    left -= internal;
    structure.condense(left);
    return {left.l2_norm(), std::max(internal.l2_norm(), load.l2_norm())};
  }



  BlockVector
  Newton::correction_at(const Equilibrium &state,
                        const LoadFactor  &to,
                        const BlockVector &moved,
                        const BlockVector &last,
                        double            &began) const
  {
    const Linearisation tangent(structure, state.u, asked, {}, last);
    BlockVector         r = structure.load(to);
    r -= structure.internal_forces(state.u);
    const bool is_first = began == 0.;
    if (is_first)
      {
        r -= tangent.apply(moved);
        began = r.l2_norm();
      }
    BlockVector correction = tangent.solve(r);
    if (is_first)
      correction += moved;
    return correction;
  }



  bool
  Newton::step(const LoadFactor &to,
               const bool        predicted,
               Equilibrium      &state) const
  {
    BlockVector moved = structure.particular(to), correction;
    moved -= structure.particular(state.factor);
    double before = std::numeric_limits<double>::max(), began = 0.;
    for (unsigned int k = 0; k < parameters.max_iterations; ++k)
      {
        ++state.iterations;
        correction = correction_at(
          state, to, moved, predicted ? correction : BlockVector(), began);
        state.u += correction;

        const Left   found = left_of(state.u, to);
        const double left  = found.norm <= parameters.nothing * began ?
                               0. :
                               found.norm / found.scale;
        if (!(found.norm <= parameters.diverged * began))
          return false;
        if (left <= parameters.balanced ||
            (left < parameters.floor && left > parameters.stalls * before) ||
            (left < parameters.near &&
             correction.linfty_norm() < parameters.still * structure.size()))
          {
            state.factor   = to;
            state.residual = left;
            return true;
          }
        before = left;
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
