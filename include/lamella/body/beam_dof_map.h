// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_beam_dof_map_h
#define lamella_body_beam_dof_map_h

#include <lamella/base/linear_algebra.h>

#include <vector>

namespace lamella
{
  /**
   * The global DoFs of a beam: (axis node i, section field alpha). Each axis
   * node carries its own list of fields (node-dependent kinematics), all of
   * them in the simplest case, and owns its DoFs: they are contiguous.
   */
  class BeamDofMap
  {
  public:
    /// @p fields_of_node: for each axis node the fields it carries, ascending;
    /// @p n_fields of them exist.
    BeamDofMap(const std::vector<std::vector<unsigned int>> &fields_of_node,
               const unsigned int                            n_fields);

    DofIndex
    n_dofs() const
    {
      return offsets.back();
    }

    unsigned int
    n_nodes() const
    {
      return kinds.size();
    }

    /// The fields that @p node carries, ascending.
    const std::vector<unsigned int> &
    fields(const unsigned int node) const
    {
      return lists[kinds[node]];
    }

    /// The DoF of the first field of @p node.
    DofIndex
    first(const unsigned int node) const
    {
      return offsets[node];
    }

    /// Place of the field @p alpha in fields(node), or -1 if not carried.
    int
    place(const unsigned int node, const unsigned int alpha) const
    {
      return places[kinds[node]][alpha];
    }

    /// The field of @p dof.
    unsigned int
    field_of(const DofIndex dof) const;

  private:
    std::vector<std::vector<unsigned int>> lists;
    std::vector<std::vector<int>>          places;
    std::vector<unsigned int>              kinds;
    std::vector<DofIndex>                  offsets;
  };
} // namespace lamella

#endif
