// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/body/beam.h>
#include <lamella/estimate/enrichment.h>
#include <lamella/estimate/operations.h>

#include <limits>

namespace lamella
{
  double
  operations(const Simulation &run)
  {
    double sum = 0.;
    for (const BodyFacts &body : run.results().bodies)
      if (body.solver)
        sum += body.solver->non_zeros * body.solver->non_zeros / body.dofs;
    return sum;
  }



  double
  operations_of_bars(const Simulation &run)
  {
    constexpr double axes = 8., of_block = 5.;
    const double     m   = fields_of_responses;
    double           sum = 0.;
    for (unsigned int b = 0; b < run.solved_scene().bodies.size(); ++b)
      {
        const BodyDescription &body = run.solved_scene().bodies[b];
        const auto *const      shape =
          dynamic_cast<const Beam *>(run.solved_structure().bodies()[b].get());
        if (shape == nullptr || body.theory.kind != Theory::Kind::LE ||
            !body.pieces.empty() ||
            2. * shape->n_dofs() <= most_dofs_of_layers ||
            shape->section().n_fields() <= 2. * m)
          return std::numeric_limits<double>::infinity();
        sum += axes * shape->axis().n_nodes() * of_block * m * m * m;
      }
    return sum;
  }
} // namespace lamella
