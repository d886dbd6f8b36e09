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
   *
   *   DoF of (i, alpha) = first(i) + place(i, alpha),
   *   first(i) = sum over j < i of the number of fields(j).
   *
   * So node after node along the axis, which keeps the stiffness banded in the
   * axis and gives each process, which has some nodes in a row, DoFs in a row.
   * In the paper's words the DoF u_(tau i), a vector of three components; here
   * components and expansion functions are together the one index alpha.
   *
   * Nodes with the same list share one copy of it, so that the map takes a few
   * bytes a node however many fields there are. It knows the numbers of the
   * fields and not what they are.
   */
  class BeamDofMap
  {
  public:
    /// @p fields_of_node: for each axis node the fields it carries, ascending
    /// and below @p n_fields, as many as the section has. A field that a node
    /// does not carry is zero there.
    BeamDofMap(const std::vector<std::vector<unsigned int>> &fields_of_node,
               const unsigned int                            n_fields);

    /// The sum of the lengths of all lists.
    DofIndex
    n_dofs() const
    {
      return offsets.back();
    }

    /// Of the axis.
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

    /// The DoF of the first field of @p node; the others follow in the order of
    /// fields(node).
    DofIndex
    first(const unsigned int node) const
    {
      return offsets[node];
    }

    /// Place of the field @p alpha in fields(node), or -1 if not carried. A
    /// look-up, no search.
    int
    place(const unsigned int node, const unsigned int alpha) const
    {
      return places[kinds[node]][alpha];
    }

    /// The node of @p dof, by bisection.
    unsigned int
    node_of(const DofIndex dof) const;

    /// The field alpha of @p dof, by bisection over the nodes.
    unsigned int
    field_of(const DofIndex dof) const;

  private:
    /// The different lists of fields, and for each of them the place of every
    /// field in it, -1 for those that it has not.
    std::vector<std::vector<unsigned int>> lists;
    std::vector<std::vector<int>>          places;
    /// Of each node the number of its list; first(node), and n_dofs() behind
    /// the last.
    std::vector<unsigned int> kinds;
    std::vector<DofIndex>     offsets;
  };
} // namespace lamella

#endif
