// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/estimate/penalty_share.h>

namespace lamella
{
  PenaltyShare::PenaltyShare(const Simulation &run)
  {
    std::vector<GapRow> rows(run.model().rows().begin(),
                             run.model().rows().end());
    for (GapRow &row : rows)
      row.enforcement = Enforcement::exact;
    const GapRows view(rows);
    ContactSolver solver(run.contact_solver().shared_tangent(),
                         view,
                         run.model().scene().solve.loop,
                         run.model().scene().solve.strategy);
    const auto   &last   = run.results().last();
    const double  factor = last.load_factor;
    const State   exact  = solver.release_springs(
      solver.solve_contact(solver.solve_free(factor), factor, last.state),
      factor);

    u = exact.u;
    u -= last.state.u;
    std::vector<unsigned int> touching;
    for (unsigned int r = 0; r < rows.size(); ++r)
      {
        const double now = exact.active.empty() ? 0. : exact.force[r],
                     before =
                       last.state.active.empty() ? 0. : last.state.force[r];
        force.push_back(now - before);
        if (now != 0. || before != 0.)
          touching.push_back(r);
      }
    dual = std::make_unique<const GoalDual>(run, touching);
  }



  std::optional<double>
  PenaltyShare::of(const NamedQuantity &goal) const
  {
    const auto derivative = dual->derivative(goal);
    if (!derivative)
      return std::nullopt;
    double      sum    = derivative->u * u;
    const auto &active = dual->active_rows();
    for (unsigned int k = 0; k < active.size(); ++k)
      sum += derivative->force[k] * force[active[k]];
    return sum;
  }
} // namespace lamella
