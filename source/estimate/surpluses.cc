// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/estimate/local_errors.h>
#include <lamella/estimate/surpluses.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  namespace
  {
    bool
    is_longer(const double one, const double other)
    {
      return one > (1. + arithmetic::same_in_element) * other;
    }



    /// Returns whether elements of @p lengths get shorter toward the start of
    /// number @p k, from both sides unless it is at an end.
    bool
    is_place(const std::vector<double> &lengths, const std::size_t k)
    {
      const bool before = k >= 2 && is_longer(lengths[k - 2], lengths[k - 1]),
                 behind = k + 1 < lengths.size() &&
                          is_longer(lengths[k + 1], lengths[k]);
      return (before || k == 1) && (behind || k + 1 == lengths.size()) &&
             (before || behind);
    }



    /// Appends the ends of the elements @p begin to @p end of @p lengths,
    /// merged in pairs, to @p ends. If their number is odd, three are merged:
    /// the longest (or its neighbor) and the next two, at the end two before.
    void
    merge_pairs(const std::vector<double> &lengths,
                const std::size_t          begin,
                const std::size_t          end,
                std::vector<double>       &ends)
    {
      std::size_t third = end;
      if ((end - begin) % 2 == 1)
        {
          third =
            std::max_element(lengths.begin() + begin, lengths.begin() + end) -
            lengths.begin();
          third -= (third - begin) % 2;
        }
      double y = ends.empty() ? 0. : ends.back();
      for (std::size_t k = begin; k < end; ++k)
        {
          y += lengths[k];
          const std::size_t in_pairs = k < third ? k - begin : k - third - 1;
          if (k + 1 == end && k == third && k > begin)
            ends.back() = y;
          else if (k + 1 == end || (k != third && in_pairs % 2 == 1))
            ends.push_back(y);
        }
    }



    /// Appends the ends of merged elements @p begin to @p end of @p lengths, of
    /// a graded part of an axis, to @p ends.
    void
    merge_graded(const std::vector<double> &lengths,
                 const std::size_t          begin,
                 const std::size_t          end,
                 std::vector<double>       &ends)
    {
      const std::vector<double> own(lengths.begin() + begin,
                                    lengths.begin() + end);
      std::size_t               last = begin;
      for (std::size_t k = 1; k <= own.size(); ++k)
        if (k == own.size() || is_place(own, k))
          {
            merge_pairs(lengths, last, begin + k, ends);
            last = begin + k;
          }
    }
  } // namespace



  AxisMesh
  halved(const AxisMesh &axis)
  {
    const std::vector<double> lengths = element_lengths(axis);
    std::vector<double>       ends;
    std::vector<unsigned int> elements;
    std::size_t               k = 0;
    for (std::size_t s = 0; s < axis.elements.size();)
      {
        // Segments of one element each are graded.
        std::size_t n         = axis.elements[s++];
        const bool  is_graded = n == 1;
        while (is_graded && s < axis.elements.size() && axis.elements[s] == 1)
          ++n, ++s;
        if (is_graded)
          merge_graded(lengths, k, k + n, ends);
        else if (n % 2 == 1)
          merge_pairs(lengths, k, k + n, ends);
        else
          ends.push_back((ends.empty() ? 0. : ends.back()) + n * lengths[k]);
        elements.resize(ends.size(), 1);
        if (n % 2 == 0 && !is_graded)
          elements.back() = n / 2;
        k += n;
      }
    AxisMesh result = axis;
    // The last one is the end of the axis.
    ends.pop_back();
    result.breaks   = ends;
    result.elements = elements;
    return result;
  }



  std::vector<AxisSpan>
  coarser_spans(AxisMesh axis, const unsigned int times)
  {
    const auto with_degrees = [&axis](const std::vector<AxisSpan> &before) {
      std::vector<AxisSpan> spans;
      double                end = 0.;
      for (const double length : element_lengths(axis))
        {
          AxisSpan span{end, end + length, axis.degree};
          end = span.end;
          for (const AxisSpan &old : before)
            if (std::abs(old.begin - span.begin) +
                  std::abs(old.end - span.end) <
                arithmetic::same_in_element * length)
              span.degree = std::max(old.degree - 1, 1u);
          spans.push_back(span);
        }
      return spans;
    };
    std::vector<AxisSpan> spans = with_degrees({});
    for (unsigned int time = 0; time < times; ++time)
      {
        axis  = halved(axis);
        spans = with_degrees(spans);
      }
    return spans;
  }



  Scene
  with_halved_axes(Scene scene)
  {
    for (BodyDescription &body : scene.bodies)
      if (!body.theory.is_solid())
        body.axis = halved(body.axis);
    return scene;
  }



  Scene
  with_lower_degree(Scene scene)
  {
    const auto poorer = [](Theory &theory) {
      if (theory.is_layerwise() && theory.order > 1)
        --theory.order;
    };
    for (BodyDescription &body : scene.bodies)
      {
        poorer(body.theory);
        for (Theory &theory : body.pieces.theories)
          poorer(theory);
      }
    return scene;
  }



  Scene
  with_fewer_waves(Scene scene, const unsigned int fewer)
  {
    for (BodyDescription &body : scene.bodies)
      if (body.theory.has_responses())
        body.theory.order -= std::min(fewer, body.theory.order - 1);
    return scene;
  }



  Scene
  with_lower_section_order(Scene scene)
  {
    for (BodyDescription &body : scene.bodies)
      if (body.theory.is_saint_venant() && body.theory.section_order > 1)
        --body.theory.section_order;
    return with_lower_degree(scene);
  }



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
