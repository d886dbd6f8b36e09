// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/body/beam_dof_map.h>

#include <algorithm>

namespace lamella
{
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
} // namespace lamella
