// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/estimate/coarser_scenes.h>
#include <lamella/estimate/local_errors.h>
#include <lamella/estimate/surpluses.h>
#include <lamella/scene/scene.h>

namespace lamella
{
  std::string
  Surpluses::unavailable_reason(const Simulation  &run,
                                const unsigned int min_degree)
  {
    if (const ContactPair *contact = first_with_friction(run.model().scene()))
      return "contact " + contact->name + " has friction";
    const Bodies &bodies = run.model().structure().bodies();
    const auto    beams  = beams_of(bodies);
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const Beam *const beam = beams[b];
        if (beam == nullptr || !BeamSurplus::is_possible(*beam) ||
            beam->section().element().degree() < min_degree)
          return "body " + bodies[b]->name() + " is no beam of LE-" +
                 std::to_string(min_degree) + " or more";
      }
    return "";
  }



  Surpluses::Surpluses(const Simulation &run)
    : run(run)
  {
    for (const Beam *const beam : beams_of(run.model().structure().bodies()))
      of_beams.push_back(std::make_unique<const BeamSurplus>(*beam));
    for (const BodyDescription &body : run.model().scene().bodies)
      {
        halves.push_back(coarser_spans(body.axis, 1));
        quarters.push_back(coarser_spans(body.axis, 2));
      }
    const Parts parts = parts_of(run.results().last().state.u);
    for (const auto &[part_forces, part] :
         {std::make_pair(&section, &parts.section),
          std::make_pair(&section_before, &parts.section_before),
          std::make_pair(&axis, &parts.axis),
          std::make_pair(&axis_before, &parts.axis_before)})
      *part_forces = std::make_unique<const PartForces>(forces_of_part(*part));
  }



  Vector
  Surpluses::jumps(const BlockVector &v) const
  {
    const auto &active = run.results().last().state.active;
    Vector      result(active.size());
    for (unsigned int k = 0; k < active.size(); ++k)
      result[k] = run.model().rows()[active[k]].jump(v);
    return result;
  }



  Surpluses::PartForces
  Surpluses::forces_of_part(const BlockVector &v) const
  {
    const BlockVector zero = run.model().structure().zero();
    PartForces  part_forces{run.linear_system().tangent().apply(v), jumps(v)};
    const auto &active = run.results().last().state.active;
    if (active.empty())
      return part_forces;
    Vector jump = part_forces.rows;
    jump *= -1.;
    BlockVector unused = zero;
    run.linear_system().solve_linear(
      active, zero, jump, unused, part_forces.rows);
    return part_forces;
  }



  double
  Surpluses::work(const PartForces &part_forces, const BlockVector &z) const
  {
    double       sum  = part_forces.bodies * z;
    const Vector jump = jumps(z);
    for (unsigned int k = 0; k < jump.size(); ++k)
      sum -= part_forces.rows[k] * jump[k];
    return sum;
  }



  Surpluses::Parts
  Surpluses::parts_of(const BlockVector &v) const
  {
    const BlockVector zero = run.model().structure().zero();
    Parts             parts{zero, zero, zero, zero};
    for (unsigned int b = 0; b < of_beams.size(); ++b)
      {
        const BeamSurplus &surplus = *of_beams[b];
        const unsigned int p       = surplus.section_degree();
        Vector             rest    = v.block(b);
        parts.section.block(b)     = surplus.in_section(rest, p - 1);
        rest -= parts.section.block(b);
        parts.section_before.block(b) = surplus.in_section(rest, p - 2);

        rest                = v.block(b);
        parts.axis.block(b) = surplus.along_axis(rest, halves[b]);
        rest -= parts.axis.block(b);
        parts.axis_before.block(b) = surplus.along_axis(rest, quarters[b]);
      }
    return parts;
  }



  void
  Surpluses::add_spans(const unsigned int body,
                       const Vector      &products,
                       LocalErrors       &result) const
  {
    const Beam &beam = *beams_of(run.model().structure().bodies())[body];
    const Axis &axis = beam.axis();
    for (const AxisSpan &span : halves[body])
      {
        const double near =
          arithmetic::same_in_element * (span.end - span.begin);
        double error = 0.;
        for (unsigned int node = 0; node < axis.n_nodes(); ++node)
          if (const double y = axis.nodes()[node];
              y > span.begin + near && y < span.end - near)
            for (unsigned int k = 0; k < beam.dofs().fields(node).size(); ++k)
              error += products[beam.dofs().first(node) + k];
        result.elements.push_back({body, span.begin, span.end, error, 0});
      }
  }



  LocalErrors
  Surpluses::by_elements(const PartForces  &part_forces,
                         const BlockVector &z) const
  {
    LocalErrors result;
    for (unsigned int b = 0; b < of_beams.size(); ++b)
      {
        Vector products = part_forces.bodies.block(b);
        products.scale(z.block(b));
        add_spans(b, products, result);
      }
    const Vector jump = jumps(z);
    for (unsigned int k = 0; k < jump.size(); ++k)
      result.contact -= part_forces.rows[k] * jump[k];
    return distribute_to_finer(result, run);
  }



  SurplusParts
  Surpluses::of(const BlockVector &z) const
  {
    const Parts parts = parts_of(z);
    return {{work(*section, parts.section),
             work(*section_before, parts.section_before)},
            {work(*axis, parts.axis), work(*axis_before, parts.axis_before)},
            by_elements(*axis, parts.axis)};
  }
} // namespace lamella
