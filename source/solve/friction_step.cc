// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/friction_step.h>

#include <algorithm>
#include <set>

namespace lamella
{
  using namespace dealii;

  std::vector<Tensor<1, 3>>
  forces_by_rows(const GapConstraints &rows, const State &state)
  {
    std::vector<Tensor<1, 3>> forces(rows.size());
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        const Tensor<1, 2> shear =
          along_tangents(rows[r], state.friction.shear[r]);
        forces[r] = Tensor<1, 3>({state.force[r], shear[0], shear[1]});
      }
    return forces;
  }



  Tensor<1, 2>
  slip_in_step(const GapConstraint &row,
               const unsigned int   r,
               const State         &state,
               const LoadFactor    &factor)
  {
    return slip_of(row, state.u, factor) +
           along_tangents(row,
                          law_compliance(row) * state.friction.shear[r] -
                            state.friction.before[r]);
  }



  void
  add_friction(const GapConstraints &rows,
               const State          &state,
               const LoadFactor     &factor,
               ContactProblem       &problem)
  {
    problem.first_forces = forces_by_rows(rows, state);
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        problem.shear.push_back(
          along_tangents(rows[r], state.friction.shear[r]));
        problem.slip.push_back(
          slip_of(rows[r], state.u, factor) -
          along_tangents(rows[r], state.friction.before[r]));
      }
  }



  void
  store_forces(const GapConstraints  &rows,
               const ContactSolution &found,
               State                 &state)
  {
    state.force  = found.force;
    state.active = found.active;
    if (state.friction.empty())
      return;
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        state.friction.shear[r]     = in_scene(rows[r], found.shear[r]);
        state.friction.direction[r] = found.direction.empty() ?
                                        Tensor<1, 3>() :
                                        in_scene(rows[r], found.direction[r]);
      }
  }



  ActiveConstraints
  active_equations(const GapConstraints &rows, const State &state)
  {
    ActiveConstraints closed(state.active);
    for (const unsigned int r : state.active)
      if (!rows[r].slips.empty())
        {
          const Tensor<1, 2> e =
            along_tangents(rows[r], state.friction.direction[r]);
          if (e.norm() > 0.)
            closed.sliding.emplace_back(r, rows[r].friction * e);
          else
            for (unsigned int a = 0; a < rows[r].slips.size(); ++a)
              closed.numbers.push_back(rows.slip(r, a));
        }
    return closed;
  }



  void
  add_forces(const GapConstraints    &rows,
             const ActiveConstraints &closed,
             const Vector            &dlambda,
             State                   &state)
  {
    for (unsigned int i = 0; i < closed.numbers.size(); ++i)
      {
        const unsigned int number = closed.numbers[i], r = rows.row_of(number);
        if (number == r)
          state.force[r] += dlambda[i];
        else
          state.friction.shear[r] +=
            dlambda[i] * rows[r].slips[number - rows.slip(r, 0)].tangent;
      }
    for (const auto &[r, along] : closed.sliding)
      state.friction.shear[r] = in_scene(rows[r], state.force[r] * along);
  }



  double
  friction_error(const GapConstraint &row,
                 const unsigned int   r,
                 const State         &state,
                 const LoadFactor    &factor)
  {
    const Tensor<1, 2> v = slip_in_step(row, r, state, factor),
                       e = along_tangents(row, state.friction.direction[r]);
    return (v + v.norm() * e).norm();
  }



  namespace
  {
    /// Mean normal force of row @p r between @p before and @p state.
    double
    mean_force(const State &before, const State &state, const unsigned int r)
    {
      return 0.5 *
             (state.force[r] + (before.force.empty() ? 0. : before.force[r]));
    }



    /// Adds to what @p now remembers of row @p r what the step has @p slid, and
    /// dissipated under the @p mean force; the latter is returned.
    double
    add_loss(const GapConstraint &row,
             const unsigned int   r,
             const double         mean,
             const double         slid,
             const FrictionState &then,
             FrictionState       &now)
    {
      const double lost = row.friction * mean * slid;
      now.length[r]     = then.length[r] + slid;
      now.dissipated[r] = then.dissipated[r] + lost;
      return lost;
    }
  } // namespace



  void
  end_step(const GapConstraints &rows,
           const State          &before,
           const LoadFactor     &factor,
           State                &state)
  {
    if (state.friction.empty())
      return;
    FrictionState       &now   = state.friction;
    const FrictionState  start = FrictionState::unloaded(rows);
    const FrictionState &then =
      before.friction.empty() ? start : before.friction;
    now.path_gap = then.path_gap;
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        const bool   slips = now.direction[r].norm() > 0.;
        const double mean  = mean_force(before, state, r),
                     slid  = slips ?
                               slip_in_step(rows[r], r, state, factor).norm() :
                               0.,
                     lost  = add_loss(rows[r], r, mean, slid, then, now);
        now.contact_gap[r] = rows[r].gap(state.u, factor) +
                             law_compliance(rows[r]) * state.force[r];
        now.before[r] = in_scene(rows[r], slip_of(rows[r], state.u, factor)) +
                        law_compliance(rows[r]) * now.shear[r];
        now.path_gap -= mean * (now.contact_gap[r] - then.contact_gap[r]) +
                        0.5 * (now.shear[r] + then.shear[r]) *
                          (now.before[r] - then.before[r]) +
                        lost;
      }
  }



  void
  end_moved_step(const GapConstraints &rows,
                 const State          &before,
                 const LoadFactor     &factor,
                 State                &state)
  {
    std::set<unsigned int> pressed;
    for (const unsigned int r : state.active)
      pressed.insert(rows.contact_of_row(r).first);
    for (unsigned int r = 0; r < state.friction.shear.size(); ++r)
      {
        // Where what touches wanders points that it leaves have rubbed, too;
        // a contact that opens has been through the air for the most part.
        const double mean  = mean_force(before, state, r);
        const bool   slips = state.friction.direction[r].norm() > 0. ||
                           (state.force[r] == 0. && mean > 0. &&
                            pressed.count(rows.contact_of_row(r).first) > 0);
        add_loss(rows[r],
                 r,
                 mean,
                 slips ? slip_in_step(rows[r], r, state, factor).norm() : 0.,
                 before.friction,
                 state.friction);
        state.friction.before[r] =
          law_compliance(rows[r]) * state.friction.shear[r];
      }
  }
} // namespace lamella
