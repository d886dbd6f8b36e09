// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/local_interactions.h>
#include <lamella/adapt/section_load.h>
#include <lamella/base/arithmetic.h>
#include <lamella/body/surface_topology.h>

#include <algorithm>
#include <cmath>
#include <map>

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



    /// Section load vectors by the nodes of the axis. Rows, since a support of
    /// a whole body has as many as it has nodes, of few entries each.
    using ByNode = std::map<unsigned int, LinearFunctional>;

    /// The row's weights, their DoFs the fields of the section.
    ByNode
    by_node(const Beam &beam, const LinearFunctional &row)
    {
      ByNode result;
      for (const auto &[dof, weight] : row.entries())
        {
          const unsigned int node = beam.dofs().node_of(dof);
          result[node].add(
            beam.dofs().fields(node)[dof - beam.dofs().first(node)], weight);
        }
      for (auto &[node, part] : result)
        part.compress();
      return result;
    }



    double
    l2_norm(const LinearFunctional &f)
    {
      double sum = 0.;
      for (const auto &[field, weight] : f.entries())
        sum += weight * weight;
      return std::sqrt(sum);
    }



    double
    largest_weight(const LinearFunctional &f)
    {
      double largest = 0.;
      for (const auto &[field, weight] : f.entries())
        largest = std::max(largest, std::abs(weight));
      return largest;
    }



    /// Where along the axis the weights of @p nodes are: on the elements all of
    /// whose nodes have one, or at nodes.
    AxisPart
    place_of(const Axis &axis, const ByNode &nodes)
    {
      double largest = 0.;
      for (const auto &[node, part] : nodes)
        largest = std::max(largest, largest_weight(part));
      const auto has = [&](const unsigned int node) {
        const auto found = nodes.find(node);
        return found != nodes.end() &&
               largest_weight(found->second) >
                 arithmetic::rounding_of_solutions * largest;
      };
      AxisPart on{axis.length(), 0., axis.length()}, at = on;
      bool     any = false;
      for (unsigned int cell = 0; cell < axis.n_cells(); ++cell)
        {
          const auto  &members = axis.nodes_of_cell(cell);
          const double begin = axis.cell_begin(cell), end = axis.cell_end(cell);
          if (std::all_of(members.begin(), members.end(), has))
            {
              any        = true;
              on.begin   = std::min(on.begin, begin);
              on.end     = std::max(on.end, end);
              on.element = std::min(on.element, end - begin);
            }
          else if (std::any_of(members.begin(), members.end(), has))
            at.element = std::min(at.element, end - begin);
        }
      for (const auto &[node, part] : nodes)
        if (has(node))
          {
            at.begin = std::min(at.begin, axis.nodes()[node]);
            at.end   = std::max(at.end, axis.nodes()[node]);
          }
      return any ? on : at;
    }



    /// @p f without what acts along the axis, unless that is most of it.
    LinearFunctional
    without_axial(const LinearFunctional &f,
                  const Section          &section,
                  const InteractionRules &rules)
    {
      double           axial = 0.;
      LinearFunctional rest;
      for (const auto &[field, weight] : f.entries())
        if (section.field(field).terms[0].component == 1)
          axial += weight * weight;
        else
          rest.add(field, weight);
      return std::sqrt(axial) > rules.along_axis * l2_norm(f) ? f : rest;
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



  SectionLoad
  load_of_row(const Beam             &beam,
              const LinearFunctional &row,
              const Point<3>         &position,
              const double            area,
              const bool              normal,
              const InteractionRules &rules)
  {
    const auto       nodes = by_node(beam, row);
    LinearFunctional f;
    // The functions of the axis sum to one.
    for (const auto &[node, part] : nodes)
      f.add(part, 1.);
    f.compress();
    const Point<3> x = beam.place().to_body(position);
    return {normal ? without_axial(f, beam.section(), rules) : f,
            place_of(beam.axis(), nodes),
            {x[0], x[2]},
            area,
            nodes.size() == 1,
            false};
  }



  std::vector<SectionLoad>
  loads_of_vector(const Beam              &beam,
                  const Vector            &load,
                  const std::vector<bool> &requested,
                  const InteractionRules  &rules)
  {
    LinearFunctional row;
    for (unsigned int dof = 0; dof < load.size(); ++dof)
      if (load[dof] != 0.)
        row.add(dof, load[dof]);
    const auto nodes   = by_node(beam, row);
    double     largest = 0.;
    for (const auto &[node, part] : nodes)
      largest = std::max(largest, l2_norm(part));
    std::vector<SectionLoad> loads;
    const Axis              &axis = beam.axis();
    for (unsigned int cell = 0; cell < axis.n_cells(); ++cell)
      {
        if (!requested[cell])
          continue;
        ByNode here;
        for (const unsigned int node : axis.nodes_of_cell(cell))
          if (const auto found = nodes.find(node); found != nodes.end())
            here.insert(*found);
        for (const auto &[node, part] : here)
          if (l2_norm(part) > rules.min_weight_share * largest)
            loads.push_back(
              {part, place_of(axis, here), {}, l2_norm(part), false, false});
      }
    return loads;
  }



  std::vector<Vector>
  independent_loads(const std::vector<SectionLoad> &loads,
                    const unsigned int              n_fields,
                    const InteractionRules         &rules)
  {
    std::vector<Vector> result, basis;
    for (const SectionLoad &load : loads)
      {
        const double norm = l2_norm(load.f);
        if (!(norm > 0.))
          continue;
        Vector f(n_fields);
        load.f.add_to(f, 1. / norm);
        Vector left = f;
        for (const Vector &one : basis)
          left.add(-(one * left), one);
        if (left.l2_norm() < rules.independent)
          continue;
        left /= left.l2_norm();
        basis.push_back(left);
        result.push_back(f);
      }
    return result;
  }



  std::vector<Vector>
  smooth_loads(const std::vector<SectionLoad> &loads,
               const unsigned int              n_fields)
  {
    Point<2>     low = loads[0].in_section, high = low;
    Tensor<1, 2> center;
    double       area = 0.;
    for (const SectionLoad &load : loads)
      {
        for (unsigned int d = 0; d < 2; ++d)
          {
            low[d]  = std::min(low[d], load.in_section[d]);
            high[d] = std::max(high[d], load.in_section[d]);
          }
        area += load.area;
        center += load.area * load.in_section;
      }
    center /= area;
    const unsigned int across = high[0] - low[0] >= high[1] - low[1] ? 0 : 1;
    Vector             mean(n_fields), linear(n_fields);
    for (const SectionLoad &load : loads)
      {
        load.f.add_to(mean, load.area);
        load.f.add_to(linear,
                      load.area * (load.in_section[across] - center[across]));
      }
    std::vector<Vector> result;
    if (mean.l2_norm() > 0.)
      result.push_back(mean);
    if (linear.l2_norm() > 0.)
      result.push_back(linear);
    return result;
  }
} // namespace lamella
