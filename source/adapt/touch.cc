// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/touch.h>
#include <lamella/base/arithmetic.h>

#include <algorithm>
#include <map>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Of a unit vector: less than that beside the others is nothing new.
    constexpr double independent = 0.02;
    // A load's nodes whose vectors are looked at.
    constexpr double strong = 0.05;
    // Of a row's weights: above it a row presses along the axis.
    constexpr double along_axis = 0.7;



    /// Section load vectors by the nodes of the axis. Rows, since a support of
    /// a whole body has as many as it has nodes, of few entries each.
    using ByNode = std::map<unsigned int, Row>;

    /// The row's weights, their DoFs the fields of the section.
    ByNode
    by_node(const Beam &beam, const Row &row)
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
    l2_norm(const Row &f)
    {
      double sum = 0.;
      for (const auto &[field, weight] : f.entries())
        sum += weight * weight;
      return std::sqrt(sum);
    }



    double
    largest_weight(const Row &f)
    {
      double largest = 0.;
      for (const auto &[field, weight] : f.entries())
        largest = std::max(largest, std::abs(weight));
      return largest;
    }



    /// A section load vector with where it acts.
    struct Place
    {
      /// From, to, and the shortest element there or beside.
      double begin, end, element;
    };
    struct SectionLoad
    {
      Row      f;
      Place    place;
      Point<2> in_section;
      double   area = 1.;
      /// Whether it acts at one node of the axis.
      bool at_node = false;
    };



    /// Where along the axis the weights of @p nodes are: on the elements all of
    /// whose nodes have one, or at nodes.
    Place
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
      Place on{axis.length(), 0., axis.length()}, at = on;
      bool  any = false;
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
    Row
    without_axial(const Row &f, const Section &section)
    {
      double axial = 0.;
      Row    rest;
      for (const auto &[field, weight] : f.entries())
        if (section.field(field).terms[0].component == 1)
          axial += weight * weight;
        else
          rest.add(field, weight);
      return std::sqrt(axial) > along_axis * l2_norm(f) ? f : rest;
    }



    /// A row of a support or a contact, the same section vector at all of its
    /// nodes; @p normal: without its part along the axis.
    SectionLoad
    load_of_row(const Beam     &beam,
                const Row      &row,
                const Point<3> &position,
                const double    area,
                const bool      normal)
    {
      const auto nodes = by_node(beam, row);
      Row        f;
      // The functions of the axis sum to one.
      for (const auto &[node, part] : nodes)
        f.add(part, 1.);
      f.compress();
      const Point<3> x = beam.place().to_body(position);
      return {normal ? without_axial(f, beam.section()) : f,
              place_of(beam.axis(), nodes),
              {x[0], x[2]},
              area,
              nodes.size() == 1};
    }



    /// The load vector @p load, whatever it is at each node: those of each
    /// element that it is on, of the elements @p asked.
    std::vector<SectionLoad>
    loads_of_vector(const Beam              &beam,
                    const Vector            &load,
                    const std::vector<bool> &asked)
    {
      Row row;
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
          if (!asked[cell])
            continue;
          ByNode here;
          for (const unsigned int node : axis.nodes_of_cell(cell))
            if (const auto found = nodes.find(node); found != nodes.end())
              here.insert(*found);
          for (const auto &[node, part] : here)
            if (l2_norm(part) > strong * largest)
              loads.push_back(
                {part, place_of(axis, here), {}, l2_norm(part), false});
        }
      return loads;
    }



    /// Those of @p loads, vectors of @p n_fields, that are independent, unit
    /// length each.
    std::vector<Vector>
    independent_of(const std::vector<SectionLoad> &loads,
                   const unsigned int              n_fields)
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
          if (left.l2_norm() < independent)
            continue;
          left /= left.l2_norm();
          basis.push_back(left);
          result.push_back(f);
        }
      return result;
    }



    /// The mean of @p loads and what varies linearly across, weighted with
    /// their areas.
    std::vector<Vector>
    smooth_of(const std::vector<SectionLoad> &loads,
              const unsigned int              n_fields)
    {
      Point<2>     low = loads[0].in_section, high = low;
      Tensor<1, 2> centre;
      double       area = 0.;
      for (const SectionLoad &load : loads)
        {
          for (unsigned int d = 0; d < 2; ++d)
            {
              low[d]  = std::min(low[d], load.in_section[d]);
              high[d] = std::max(high[d], load.in_section[d]);
            }
          area += load.area;
          centre += load.area * load.in_section;
        }
      centre /= area;
      const unsigned int across = high[0] - low[0] >= high[1] - low[1] ? 0 : 1;
      Vector             mean(n_fields), linear(n_fields);
      for (const SectionLoad &load : loads)
        {
          load.f.add_to(mean, load.area);
          load.f.add_to(linear,
                        load.area * (load.in_section[across] - centre[across]));
        }
      std::vector<Vector> result;
      if (mean.l2_norm() > 0.)
        result.push_back(mean);
      if (linear.l2_norm() > 0.)
        result.push_back(linear);
      return result;
    }



    /// One touch for each part of the axis that @p loads, of a section with
    /// @p n_fields, are on.
    void
    add_touches(const std::string       &name,
                const unsigned int       n_fields,
                std::vector<SectionLoad> loads,
                std::vector<Touch>      &touches)
    {
      std::stable_sort(loads.begin(),
                       loads.end(),
                       [](const SectionLoad &a, const SectionLoad &b) {
                         return a.place.begin < b.place.begin;
                       });
      for (auto begin = loads.begin(); begin != loads.end();)
        {
          Touch touch;
          touch.name    = name;
          touch.begin   = begin->place.begin;
          touch.end     = begin->place.end;
          touch.element = begin->place.element;
          bool at_node  = true;
          auto end      = begin;
          for (; end != loads.end() && end->place.begin <= touch.end; ++end)
            {
              touch.end     = std::max(touch.end, end->place.end);
              touch.element = std::min(touch.element, end->place.element);
              at_node       = at_node && end->at_node;
            }
          const std::vector<SectionLoad> here(begin, end);
          // A node's section as a whole, in one direction at least.
          touch.holds_section =
            at_node && here.size() > 30 && 4 * here.size() > n_fields;
          if (touch.holds_section)
            for (const SectionLoad &load : here)
              touch.held.push_back(load.f);
          else
            {
              touch.loads  = independent_of(here, n_fields);
              touch.smooth = smooth_of(here, n_fields);
            }
          touches.push_back(std::move(touch));
          begin = end;
        }
    }
    /// Whether on each element of its axis the heat of @p beam varies along it
    /// by more than the response to what is constant can follow.
    std::vector<bool>
    where_heat_varies(const Beam &beam)
    {
      // Over the smaller extent of the section, of the largest: the tolerance
      // of fields far from what touches.
      constexpr double    varies = 1e-2;
      const Axis         &axis   = beam.axis();
      std::vector<Vector> heat;
      double              largest = 0.;
      for (const double y : axis.nodes())
        {
          heat.push_back(beam.section_heat(y).on_values);
          largest = std::max(largest, heat.back().l2_norm());
        }
      const double      H = beam.section().extents().first;
      std::vector<bool> result;
      for (unsigned int cell = 0; cell < axis.n_cells(); ++cell)
        {
          const auto  &nodes  = axis.nodes_of_cell(cell);
          const double length = axis.cell_end(cell) - axis.cell_begin(cell);
          double       largest_change = 0.;
          for (const unsigned int node : nodes)
            {
              Vector change = heat[node];
              change -= heat[nodes[0]];
              largest_change = std::max(largest_change, change.l2_norm());
            }
          result.push_back(largest_change * H > varies * largest * length);
        }
      return result;
    }



    /// The heat of @p beam as a load where it varies along the axis.
    void
    add_heat(const Beam &beam, std::vector<Touch> &touches)
    {
      if (!beam.is_heated())
        return;
      Vector load(beam.n_dofs());
      beam.add_heat(load);
      const std::size_t before = touches.size();
      add_touches("heat",
                  beam.section().n_fields(),
                  loads_of_vector(beam, load, where_heat_varies(beam)),
                  touches);
      for (std::size_t k = before; k < touches.size(); ++k)
        touches[k].heats = true;
    }
  } // namespace



  std::vector<Touch>
  heated_free_ends(const Beam &beam, const std::vector<Touch> &touches)
  {
    const Axis        &axis = beam.axis();
    std::vector<Touch> ends;
    if (!beam.is_heated())
      return ends;
    for (const bool at_start : {true, false})
      {
        const unsigned int cell = at_start ? 0 : axis.n_cells() - 1;
        Touch              end;
        end.name            = "heated end";
        end.begin           = at_start ? 0. : axis.length();
        end.end             = end.begin;
        end.element         = axis.cell_end(cell) - axis.cell_begin(cell);
        end.is_free         = true;
        const auto holds_it = [&](const Touch &touch) {
          return touch.holds_section &&
                 std::abs(touch.begin - end.begin) <
                   arithmetic::same_place * axis.length();
        };
        if (std::none_of(touches.begin(), touches.end(), holds_it))
          ends.push_back(end);
      }
    return ends;
  }



  std::vector<Touch>
  find_touches(const Beam                          &beam,
               const unsigned int                   body,
               const Bodies                        &bodies,
               const std::vector<Support>          &supports,
               const std::vector<Load>             &loads,
               const std::vector<ContactInterface> &contacts)
  {
    const unsigned int               n_fields = beam.section().n_fields();
    std::vector<Touch>               touches;
    const std::vector<PrescribedRow> rows = prescribed_rows(supports, bodies);
    for (unsigned int s = 0; s < supports.size(); ++s)
      {
        std::vector<SectionLoad> held;
        for (const PrescribedRow &row : rows)
          if (row.support == s && row.row.body == body && !supports[s].hold)
            held.push_back(
              load_of_row(beam, row.row.row, row.position, 1., false));
        const std::size_t before = touches.size();
        add_touches("support " + supports[s].name, n_fields, held, touches);
        for (std::size_t k = before; k < touches.size(); ++k)
          touches[k].holds = true;
      }
    for (const Load &load : loads)
      {
        std::vector<types::global_dof_index> sizes;
        for (const auto &one : bodies)
          sizes.push_back(one->n_dofs());
        BlockVector vector(sizes);
        add_load(load, bodies, vector);
        add_touches("load " + load.name,
                    n_fields,
                    loads_of_vector(beam,
                                    vector.block(body),
                                    std::vector<bool>(beam.axis().n_cells(),
                                                      true)),
                    touches);
      }
    add_heat(beam, touches);
    for (const ContactInterface &contact : contacts)
      {
        std::vector<SectionLoad> pressed;
        for (unsigned int k = 0; k < contact.rows.size(); ++k)
          for (const BodyRow &part : contact.rows[k].parts)
            if (part.body == body)
              pressed.push_back(load_of_row(beam,
                                            part.row,
                                            body == contact.first_body ?
                                              contact.points[k].first :
                                              contact.points[k].second,
                                            contact.points[k].area,
                                            true));
        const std::size_t before = touches.size();
        add_touches("contact " + contact.name, n_fields, pressed, touches);
        for (std::size_t k = before; k < touches.size(); ++k)
          touches[k].presses = true;
      }
    return touches;
  }
} // namespace lamella
