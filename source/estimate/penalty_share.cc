// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/estimate/penalty_share.h>

#include <algorithm>

namespace lamella
{
  PenaltyShare::PenaltyShare(const Simulation &run)
  {
    if (!has_source(run.model().scene(), Source::contact))
      return;
    std::vector<GapRow> rows(run.model().rows().begin(),
                             run.model().rows().end());
    for (GapRow &row : rows)
      row.enforcement = Enforcement::exact;
    const GapRows     view(rows);
    ContactSolver     solver(run.contact_solver().shared_tangent(),
                         view,
                         run.model().scene().solve.loop,
                         run.model().scene().solve.strategy);
    const auto       &last   = run.results().last();
    const LoadFactor &factor = last.load_factor;
    const State       exact  = solver.release_springs(
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



  void
  PenaltyShare::compare(const std::vector<NamedQuantity> &goals,
                        OtherModels                      &others,
                        const Scene                      &poorer,
                        const ResultNumbers              &numbers)
  {
    if (!is_any() ||
        std::all_of(goals.begin(), goals.end(), [this](const auto &goal) {
          return dual->derivative(goal).has_value();
        }))
      return;
    soft = numbers;
    exact =
      others.solved(enriched(poorer, Source::contact, {}), "no penetration")
        .numbers;
  }



  double
  PenaltyShare::of(const NamedQuantity &goal) const
  {
    if (!is_any())
      return 0.;
    const auto derivative = dual->derivative(goal);
    if (!derivative)
      return exact->value(goal) - soft->value(goal);
    double      sum    = derivative->u * u;
    const auto &active = dual->active_rows();
    for (unsigned int k = 0; k < active.size(); ++k)
      sum += derivative->force[k] * force[active[k]];
    return sum;
  }
} // namespace lamella
