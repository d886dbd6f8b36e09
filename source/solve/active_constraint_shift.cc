// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/active_constraint_shift.h>

#include <algorithm>

namespace lamella
{
  ActiveConstraintShift::ActiveConstraintShift(
    const std::vector<ContactInterface> &contacts,
    const State                         &state,
    const unsigned int                   n_bodies,
    const double                         share)
    : of_bodies(n_bodies)
    , softened(contacts)
  {
    const GapConstraints all(contacts);
    for (const unsigned int number : state.active)
      {
        const auto [c, k]  = all.contact_of_row(number);
        GapConstraint &row = softened[c].rows[k];
        if (state.force[number] <= 0. || row.parts.size() != 1)
          continue;
        const double spring = share * row.penalty;
        shift.push_back({number, spring});
        of_bodies[row.parts[0].body].emplace_back(row.parts[0].row, spring);
        if (row.enforcement == Enforcement::penalty)
          row.penalty -= spring;
      }
  }



  void
  ActiveConstraintShift::remove_shift(const BlockVector &u,
                                      const LoadFactor  &factor,
                                      State             &state) const
  {
    const GapConstraints all = rows();
    for (const auto &[row, spring] : shift)
      state.force[row] += spring * all[row].gap(u, factor);
  }



  void
  ActiveConstraintShift::apply_shift(const BlockVector &u,
                                     const LoadFactor  &factor,
                                     State             &state) const
  {
    const GapConstraints all = rows();
    for (const auto &[row, spring] : shift)
      if (state.force[row] > 0.)
        {
          const double force =
            state.force[row] - spring * all[row].gap(u, factor);
          state.force[row] = std::max(0., force);
        }
    state.active.erase(std::remove_if(state.active.begin(),
                                      state.active.end(),
                                      [&](const unsigned int row) {
                                        return state.force[row] <= 0.;
                                      }),
                       state.active.end());
  }
} // namespace lamella
