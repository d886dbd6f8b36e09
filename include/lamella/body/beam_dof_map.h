// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_beam_dof_map_h
#define lamella_body_beam_dof_map_h

#include <lamella/base/linear_algebra.h>

#include <vector>

namespace lamella
{
  /// The global DoFs of a beam, pairs of axis node i and section field alpha.
  /// Each node has its own list of fields (node-dependent kinematics) and
  /// contiguous DoFs,
  ///   DoF of (i, alpha) = first(i) + place(i, alpha),
  ///   first(i) = sum over j < i of the number of fields(j),
  /// so that the stiffness is banded along the axis. alpha combines the
  /// component and the function tau of the paper's DoF u_(tau i).
  class BeamDofMap
  {
  public:
    /// Constructs the map from the fields of each axis node, ascending and
    /// below @p n_fields. Fields that a node does not carry are zero there.
    BeamDofMap(const std::vector<std::vector<unsigned int>> &fields_of_node,
               const unsigned int                            n_fields);

    /// Returns the sum of the lengths of all lists.
    DofIndex
    n_dofs() const
    {
      return offsets.back();
    }

    /// Returns the number of axis nodes.
    unsigned int
    n_nodes() const
    {
      return kinds.size();
    }

    /// Returns the fields of @p node, ascending.
    const std::vector<unsigned int> &
    fields(const unsigned int node) const
    {
      return lists[kinds[node]];
    }

    /// Returns the first DoF of @p node; the others follow as fields() do.
    DofIndex
    first(const unsigned int node) const
    {
      return offsets[node];
    }

    /// Returns the place of @p alpha in fields(node), or -1 if not carried.
    int
    place(const unsigned int node, const unsigned int alpha) const
    {
      return places[kinds[node]][alpha];
    }

    /// Returns the node of @p dof, by bisection.
    unsigned int
    node_of(const DofIndex dof) const;

    /// Returns the field alpha of @p dof, by bisection over the nodes.
    unsigned int
    field_of(const DofIndex dof) const;

  private:
    /// Distinct lists of fields, and the place of every field in each, or -1.
    std::vector<std::vector<unsigned int>> lists;
    std::vector<std::vector<int>>          places;
    /// Number of each node's list; first(node), followed by n_dofs().
    std::vector<unsigned int> kinds;
    std::vector<DofIndex>     offsets;
  };
} // namespace lamella

#endif
