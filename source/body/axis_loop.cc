// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/processes.h>
#include <lamella/body/axis_loop.h>

#include <algorithm>
#include <iterator>

namespace lamella
{
  using namespace dealii;

  BeamDofMap::BeamDofMap(
    const std::vector<std::vector<unsigned int>> &fields_of_node,
    const unsigned int                            n_fields)
    : offsets{0}
  {
    for (const std::vector<unsigned int> &fields : fields_of_node)
      {
        // Nodes with the same fields share one list.
        const auto known = std::find(lists.begin(), lists.end(), fields);
        kinds.push_back(known - lists.begin());
        if (known == lists.end())
          {
            lists.push_back(fields);
            places.emplace_back(n_fields, -1);
            for (unsigned int k = 0; k < fields.size(); ++k)
              places.back()[fields[k]] = k;
          }
        offsets.push_back(offsets.back() + fields.size());
      }
  }



  unsigned int
  BeamDofMap::node_of(const DofIndex dof) const
  {
    return std::upper_bound(offsets.begin(), offsets.end(), dof) -
           offsets.begin() - 1;
  }



  unsigned int
  BeamDofMap::field_of(const DofIndex dof) const
  {
    const unsigned int node = node_of(dof);
    return fields(node)[dof - offsets[node]];
  }



  std::vector<unsigned int>
  AxisLoop::fields_of_element(const unsigned int cell) const
  {
    const auto               &nodes  = axis.nodes_of_cell(cell);
    std::vector<unsigned int> fields = dof_map.fields(nodes[0]);
    for (unsigned int i = 1; i < nodes.size(); ++i)
      {
        const auto &list = dof_map.fields(nodes[i]);
        if (list == fields)
          continue;
        std::vector<unsigned int> both;
        std::set_union(fields.begin(),
                       fields.end(),
                       list.begin(),
                       list.end(),
                       std::back_inserter(both));
        fields.swap(both);
      }
    return fields;
  }



  void
  AxisLoop::for_each_element(const ElementCallback &use) const
  {
    std::unique_ptr<const SectionOperator> section_operator;
    const auto [begin, end] = axis.own_cells();
    for (unsigned int cell = begin; cell < end; ++cell)
      {
        std::vector<unsigned int> fields = fields_of_element(cell);
        if (section_operator == nullptr || section_operator->fields() != fields)
          section_operator = make_section_operator(space,
                                                   std::move(fields),
                                                   axis.has_assumed_shear());
        use(cell, *section_operator);
      }
  }



  FieldParts
  AxisLoop::at(const ArrayView<const AxisPoint> &stations,
               const std::vector<unsigned int>  &fields,
               const Vector                     &u) const
  {
    const auto &nodes = axis.nodes_of_cell(stations[0].cell);
    FieldParts  q     = field_parts(fields.size(), stations.size());
    for (unsigned int a = 0; a < fields.size(); ++a)
      {
        const auto at_node = [&](const unsigned int node) {
          const int place = dof_map.place(node, fields[a]);
          return place < 0 ? 0. : u[dof_map.first(node) + place];
        };
        const double first = at_node(nodes[0]);
        for (unsigned int i = 0; i < nodes.size(); ++i)
          {
            const double here = at_node(nodes[i]);
            for (unsigned int k = 0; k < stations.size(); ++k)
              {
                const AxisPoint &point = stations[k];
                q[FieldPart::value](a, k) += point.N[i] * here;
                q[FieldPart::shear_value](a, k) += point.N_shear[i] * here;
                q[FieldPart::derivative](a, k) += point.dN[i] * (here - first);
              }
          }
      }
    return q;
  }



  FieldParts
  AxisLoop::on_element(const unsigned int               cell,
                       const std::vector<unsigned int> &fields,
                       const Vector                    &u) const
  {
    return at(make_array_view(axis.integration_points(),
                              cell * n_stations(),
                              n_stations()),
              fields,
              u);
  }



  void
  AxisLoop::add_on_nodes(const unsigned int               cell,
                         const std::vector<unsigned int> &fields,
                         const FieldParts                &work,
                         Vector                          &f) const
  {
    for (unsigned int k = 0; k < n_stations(); ++k)
      {
        const unsigned int number = cell * n_stations() + k;
        const AxisPoint   &point  = axis.integration_points()[number];
        const double       weight = axis.integration_weights()[number];
        const auto        &nodes  = axis.nodes_of_cell(cell);
        for (unsigned int i = 0; i < nodes.size(); ++i)
          for (unsigned int a = 0; a < fields.size(); ++a)
            if (const int place = dof_map.place(nodes[i], fields[a]);
                place >= 0)
              f[dof_map.first(nodes[i]) + place] +=
                weight *
                (point.N[i] * work[FieldPart::value](a, k) +
                 point.N_shear[i] * work[FieldPart::shear_value](a, k) +
                 point.dN[i] * work[FieldPart::derivative](a, k));
      }
  }



  void
  AxisLoop::add_forces(const ForcesOfElement &forces_of, Vector &f) const
  {
    Vector share(f.size());
    for_each_element(
      [&](const unsigned int cell, const SectionOperator &section_operator) {
        add_on_nodes(cell,
                     section_operator.fields(),
                     forces_of(cell, section_operator).work,
                     share);
      });
    sum_over_processes(share);
    f += share;
  }



  double
  AxisLoop::energy(const unsigned int cell, const SectionForces &forces) const
  {
    double sum = 0.;
    for (unsigned int k = 0; k < n_stations(); ++k)
      sum +=
        axis.integration_weights()[cell * n_stations() + k] * forces.energy[k];
    return sum;
  }
} // namespace lamella
