// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/loaded_parts.h>
#include <lamella/adapt/local_interactions.h>
#include <lamella/base/arithmetic.h>
#include <lamella/body/surface_topology.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Vectors along an axis, one per node.
    using AlongAxis = std::vector<Vector>;



    /// Returns whether @p region of @p beam is a side or a line along the axis.
    bool
    acts_along(const Region &region, const Beam &beam)
    {
      const auto y = [&](const unsigned int k) {
        return beam.place().to_body(region.at[k])[1];
      };
      const Region::Kind kind = region.kind;
      if (kind == Region::Kind::line)
        return std::abs(y(1) - y(0)) >
               arithmetic::same_position * beam.axis().length();
      return kind == Region::Kind::surface &&
             (surface_names::is_whole_surface(region.surface) ||
              !(region.covers_end(true) || region.covers_end(false)));
    }



    /// Returns the transverse part of @p load, a vector of @p beam, at each
    /// node, in the fields of the section.
    AlongAxis
    across_axis(const Beam &beam, const Vector &load)
    {
      AlongAxis result;
      for (unsigned int node = 0; node < beam.axis().n_nodes(); ++node)
        {
          const auto &fields = beam.dofs().fields(node);
          Vector     &f      = result.emplace_back(fields.size());
          for (unsigned int k = 0; k < fields.size(); ++k)
            if (beam.section().field(fields[k]).terms[0].component != 1)
              f[k] = load[beam.dofs().first(node) + k];
        }
      return result;
    }



    /// Returns the deviation of the heat of @p beam at each node from the line
    /// through its neighbors; zero below rounding.
    AlongAxis
    heat_variations(const Beam &beam)
    {
      const std::vector<double> &y = beam.axis().nodes();
      AlongAxis heat, result(y.size(), Vector(beam.section().n_fields()));
      for (const double at : y)
        heat.push_back(beam.section_thermal_load(at).on_derivatives);
      for (unsigned int k = 1; k + 1 < y.size(); ++k)
        {
          const Vector &before = heat[k - 1], &after = heat[k + 1];
          const double  share = (y[k] - y[k - 1]) / (y[k + 1] - y[k - 1]);
          result[k].add(1. - share, before, share, after);
          result[k] -= heat[k];
          if (result[k].l2_norm() <= arithmetic::rounding_of_results *
                                       (before.l2_norm() + after.l2_norm()))
            result[k] = 0.;
        }
      return result;
    }



    /// Adds the parts of the axis of @p beam that @p f loads to @p parts:
    /// pieces between @p ends of spans and changes of its sign. Spans shorter
    /// than the height of the section are omitted: elements are short.
    void
    add_parts(const Beam              &beam,
              const AlongAxis         &f,
              std::vector<double>      ends,
              std::vector<LoadedPart> &parts)
    {
      const std::vector<double> &y       = beam.axis().nodes();
      double                     largest = 0., begin = y.back(), end = 0.;
      for (const Vector &one : f)
        largest = std::max(largest, one.l2_norm());
      const Vector *before = nullptr;
      for (unsigned int k = 0; k < y.size(); ++k)
        if (f[k].l2_norm() > InteractionRules().min_weight_share * largest)
          {
            if (before != nullptr && *before * f[k] < 0.)
              ends.push_back(y[k]);
            before = &f[k];
            begin  = std::min(begin, y[k]);
            end    = std::max(end, y[k]);
          }
      std::sort(ends.begin(), ends.end());
      for (unsigned int k = 0; k + 1 < ends.size(); ++k)
        if (const LoadedPart part{std::max(begin, ends[k]),
                                  std::min(end, ends[k + 1]),
                                  ends[k + 1] - ends[k]};
            part.begin < part.end && part.span > beam.section().extents().first)
          parts.push_back(part);
    }
  } // namespace



  std::vector<LoadedPart>
  loaded_parts(const unsigned int               body,
               const Bodies                    &bodies,
               const std::vector<Load>         &loads,
               const Tensor<1, 3>              &gravity,
               const std::vector<ShortElement> &places)
  {
    const Beam             &beam = *beams_of(bodies)[body];
    std::vector<double>     ends{0., beam.axis().length()};
    std::vector<LoadedPart> parts;
    for (const ShortElement &place : places)
      if (place.holds)
        ends.push_back(place.y);
    const auto add = [&](const AlongAxis &f) {
      add_parts(beam, f, ends, parts);
    };
    for (Load load : loads)
      {
        const auto is_beside = [&](const Region &region) {
          return region.body != body || !acts_along(region, beam);
        };
        load.on.erase(std::remove_if(load.on.begin(), load.on.end(), is_beside),
                      load.on.end());
        if (!load.on.empty())
          add(across_axis(beam, load_vector_on(load, body, bodies)));
      }
    if (gravity.norm() > 0.)
      {
        Vector weight(beam.n_dofs());
        beam.add_weight(gravity, weight);
        add(across_axis(beam, weight));
      }
    if (beam.is_heated())
      add(heat_variations(beam));
    return parts;
  }
} // namespace lamella
