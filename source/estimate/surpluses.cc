// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/estimate/surpluses.h>

#include <cmath>

namespace lamella
{
  namespace
  {
    /// Sum over the nodes of all beams of the size of what each has of the
    /// product of @p v and @p w.
    double
    sum_of_sizes(const std::vector<const Beam *> &beams,
                 const BlockVector               &v,
                 const BlockVector               &w)
    {
      double sum = 0.;
      for (unsigned int b = 0; b < beams.size(); ++b)
        for (unsigned int node = 0; node < beams[b]->axis().n_nodes(); ++node)
          {
            const DofIndex first = beams[b]->dofs().first(node);
            double         part  = 0.;
            for (unsigned int k = 0; k < beams[b]->dofs().fields(node).size();
                 ++k)
              part += v.block(b)[first + k] * w.block(b)[first + k];
            sum += std::abs(part);
          }
      return sum;
    }
  } // namespace



  std::string
  Surpluses::reason_for_none(const Simulation  &run,
                             const unsigned int least_degree)
  {
    const Bodies &bodies = run.model().structure().bodies();
    const auto    beams  = beams_of(bodies);
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const Beam *const beam = beams[b];
        if (beam == nullptr || !BeamSurplus::is_possible(*beam) ||
            beam->section().element().degree() < least_degree)
          return "body " + bodies[b]->name() + " is no beam of LE-" +
                 std::to_string(least_degree) + " or more on elements B3 or B4";
      }
    return "";
  }



  Surpluses::Surpluses(const Simulation &run)
    : run(run)
  {
    for (const Beam *const beam : beams_of(run.model().structure().bodies()))
      of_beams.push_back(std::make_unique<const BeamSurplus>(*beam));
    forces                       = parts_of(run.results().last().state.u);
    const Linearisation &tangent = run.contact_solver().tangent();
    for (BlockVector *part : {&forces.section,
                              &forces.section_before,
                              &forces.axis,
                              &forces.axis_before})
      *part = tangent.apply(*part);
  }



  Surpluses::Parts
  Surpluses::parts_of(const BlockVector &v) const
  {
    const BlockVector zero = run.model().structure().zero();
    Parts             parts{zero, zero, zero, zero};
    for (unsigned int b = 0; b < of_beams.size(); ++b)
      {
        const BeamSurplus &surplus = *of_beams[b];
        const unsigned int p       = surplus.section_degree(),
                           r       = surplus.axis_degree();
        Vector rest                = v.block(b);
        parts.section.block(b)     = surplus.in_section(rest, p - 1);
        rest -= parts.section.block(b);
        parts.section_before.block(b) = surplus.in_section(rest, p - 2);

        rest                = v.block(b);
        parts.axis.block(b) = surplus.along_axis(rest, r - 1);
        rest -= parts.axis.block(b);
        // The space of one degree has no functions inside of elements to drop.
        if (r > 2)
          parts.axis_before.block(b) = surplus.along_axis(rest, r - 2);
      }
    return parts;
  }



  SurplusBySource
  Surpluses::of(const BlockVector &z) const
  {
    const Parts parts = parts_of(z);
    const auto  beams = beams_of(run.model().structure().bodies());
    return {{forces.section * parts.section,
             forces.section_before * parts.section_before,
             sum_of_sizes(beams, forces.section, parts.section)},
            {forces.axis * parts.axis,
             forces.axis_before * parts.axis_before,
             sum_of_sizes(beams, forces.axis, parts.axis)}};
  }
} // namespace lamella
