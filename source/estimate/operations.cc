// SPDX-License-Identifier: LGPL-2.1-or-later

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
    constexpr double            axes = 8., of_block = 5.;
    const double                m     = fields_of_responses;
    double                      sum   = 0.;
    const std::vector<BodySize> sizes = sizes_of(run);
    for (unsigned int b = 0; b < sizes.size(); ++b)
      {
        if (!may_have_responses(run.solved_scene().bodies[b], sizes[b]) ||
            2. * sizes[b].dofs <= most_dofs_of_layers)
          return std::numeric_limits<double>::infinity();
        sum += axes * sizes[b].nodes * of_block * m * m * m;
      }
    return sum;
  }
} // namespace lamella
