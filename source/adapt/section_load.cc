// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/section_load.h>
#include <lamella/base/arithmetic.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace lamella
{
  using namespace dealii;

  namespace
  {
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
