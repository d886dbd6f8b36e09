// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_beam_dof_map_h
#define lamella_body_beam_dof_map_h

#include <lamella/base/linear_algebra.h>

#include <vector>

namespace lamella
{
  /// Numbering of the DoFs of a beam. A DoF is the amplitude of a section
  /// function at an axis node. Each node has its own list of section functions
  /// (node-dependent kinematics) and contiguous DoFs,
  ///   DoF of (i, alpha) = first(i) + place(i, alpha),
  /// for node i and section function alpha, which is entry place(i, alpha) of
  /// the ascending list fields(i) of the section functions of node i.
  class BeamDofMap
  {
  public:
    /// Constructs the map from the list of section functions of each axis node,
    /// ascending and below @p n_fields.
    BeamDofMap(const std::vector<std::vector<unsigned int>> &fields_of_node,
               const unsigned int                            n_fields);

    /// Returns the number of DoFs: section functions, summed over all nodes.
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

    /// Returns the indices of the section functions of @p node, ascending.
    const std::vector<unsigned int> &
    fields(const unsigned int node) const
    {
      return lists[kinds[node]];
    }

    /// Returns the first DoF of @p node. Its DoFs are in the order of fields().
    DofIndex
    first(const unsigned int node) const
    {
      return offsets[node];
    }

    /// Returns the index of section function @p alpha in the list fields() of
    /// @p node, or -1 if the node does not have this function.
    int
    place(const unsigned int node, const unsigned int alpha) const
    {
      return places[kinds[node]][alpha];
    }

    /// Returns the axis node of @p dof, by bisection.
    unsigned int
    node_of(const DofIndex dof) const;

    /// Returns the index of the section function of @p dof, by bisection.
    unsigned int
    field_of(const DofIndex dof) const;

  private:
    std::vector<std::vector<unsigned int>> lists; ///< Distinct lists of fields.
    std::vector<std::vector<int>> places;  ///< place() for each of `lists`.
    std::vector<unsigned int>     kinds;   ///< Index in `lists` for each node.
    std::vector<DofIndex>         offsets; ///< first() of nodes, then n_dofs().
  };
} // namespace lamella

#endif
