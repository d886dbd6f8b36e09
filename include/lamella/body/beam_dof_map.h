// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_beam_dof_map_h
#define lamella_body_beam_dof_map_h

#include <lamella/base/linear_algebra.h>

#include <vector>

namespace lamella
{
  /// Numbering of the DoFs of a beam. A DoF is the amplitude of a section
  /// function alpha at an axis node i. Each node has its own list of section
  /// functions (node-dependent kinematics) and contiguous DoFs,
  ///   DoF of (i, alpha) = first(i) + place(i, alpha),
  ///   first(i) = sum over j < i of the length of fields(j),
  /// with place(i, alpha) the index of alpha in the list fields(i) of node i.
  class BeamDofMap
  {
  public:
    /// Constructs the map from the section functions of each axis node,
    /// ascending and below @p n_fields. Amplitudes of other functions are zero.
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

    /// Returns the section functions of @p node, ascending.
    const std::vector<unsigned int> &
    fields(const unsigned int node) const
    {
      return lists[kinds[node]];
    }

    /// Returns the first DoF of @p node; DoFs are in the order of fields().
    DofIndex
    first(const unsigned int node) const
    {
      return offsets[node];
    }

    /// Returns the index of @p alpha in fields(node), or -1 if it is missing.
    int
    place(const unsigned int node, const unsigned int alpha) const
    {
      return places[kinds[node]][alpha];
    }

    /// Returns the node of @p dof, by bisection.
    unsigned int
    node_of(const DofIndex dof) const;

    /// Returns the section function alpha of @p dof, by bisection.
    unsigned int
    field_of(const DofIndex dof) const;

  private:
    /// Distinct lists of section functions, and place() for each list.
    std::vector<std::vector<unsigned int>> lists;
    std::vector<std::vector<int>>          places;
    /// Index of each node's list in `lists`; first(node), followed by n_dofs().
    std::vector<unsigned int> kinds;
    std::vector<DofIndex>     offsets;
  };
} // namespace lamella

#endif
