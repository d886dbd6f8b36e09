// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/boundary_layer_modes.h>
#include <lamella/body/beam.h>
#include <lamella/estimate/bar_costs.h>
#include <lamella/estimate/enrichment.h>

#include <cmath>
#include <limits>

namespace lamella
{
  namespace
  {
    double
    operations(const BodySummary &body)
    {
      return body.solver ?
               operations_of_factor(body.solver->non_zeros, body.dofs) :
               0.;
    }



    std::size_t
    n_load_vectors(const std::vector<LocalInteraction> &touches)
    {
      std::size_t n = 0;
      for (const LocalInteraction &touch : touches)
        if (!touch.constrains_section)
          n += touch.loads.size();
      return n;
    }
  } // namespace



  double
  operations(const Simulation &run)
  {
    double sum = 0.;
    for (const BodySummary &body : run.results().bodies)
      sum += operations(body);
    return sum;
  }



  double
  operations_of_bars(const Simulation &run,
                     const PlanRules  &rules,
                     const CostRules  &cost)
  {
    const double                m      = rules.fields_of_responses;
    double                      sum    = 0.;
    const std::vector<BodySize> sizes  = sizes_of(run.model());
    const Bodies               &bodies = run.model().structure().bodies();
    const Scene                &scene  = run.model().scene();
    const auto                  beams  = beams_of(bodies);
    for (unsigned int b = 0; b < sizes.size(); ++b)
      {
        if (!may_have_responses(scene.bodies[b], sizes[b], rules) ||
            2. * sizes[b].dofs <= rules.max_layerwise_dofs)
          return std::numeric_limits<double>::infinity();
        sum += cost.axes * sizes[b].nodes * cost.of_block * m * m * m;
        // The body is LE-N, since it may have responses: a beam.
        const Beam  &beam    = *beams[b];
        const auto   touches = find_interactions(beam,
                                               b,
                                               bodies,
                                               scene.supports,
                                               scene.loads,
                                               run.model().interfaces());
        const double answers = 2. * cost.waves * n_load_vectors(touches);
        sum += sizes[b].fields * answers * answers +
               cost.of_eigenvectors * answers * answers * answers;
        sum += double(nodes_of_pieces(beam, touches)) / sizes[b].nodes *
               operations(run.results().bodies[b]);
      }
    return sum;
  }



  double
  operations_of_coarser_axes(const Scene                 &rich,
                             const std::vector<BodySize> &sizes,
                             const unsigned int           times)
  {
    double sum = 0.;
    for (unsigned int b = 0; b < sizes.size(); ++b)
      {
        const double nodes = sizes[b].nodes * std::pow(0.5, times);
        const auto   take  = [&](const unsigned int degree) {
          const double m = layerwise_dofs(sizes[b], degree) / sizes[b].nodes;
          return CostRules().of_block * nodes * m * m * m;
        };
        // The finer section, and one degree less.
        const unsigned int degree = rich.bodies[b].theory.order;
        sum += take(degree) + (degree > 1 ? take(degree - 1) : 0.);
      }
    return sum;
  }
} // namespace lamella
