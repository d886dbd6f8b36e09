// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_surface_topology_h
#define lamella_body_surface_topology_h

#include <lamella/body/body.h>

#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace lamella
{
  /**
   * How the facets of a surface hang together, by the body's own numbers: two
   * facets share a node if the meshes below say so, not because two points are
   * close (the lips of a slit are at one place and do not belong together).
   *
   * Each facet has two Gauss-Lobatto grids, the first coordinate running
   * fastest: that of the expansion (degree_s + 1) x (degree_t + 1), whose nodes
   * contact uses, and that of the trace, whose values fix the displacement on
   * the facet. They are numbered on their own, in the order in which the facets
   * come to them.
   *
   * This is what a continuous space on a surface is made of: the hats of
   * weighted gaps (mortar contact) sit at grid nodes, and two facets of one hat
   * are those that name the same number. Numbers are those of this surface,
   * from 0 on without gaps, and mean nothing to the body.
   *
   * Plain numbers once it is made; it does not refer to the body.
   */
  struct SurfaceTopology
  {
    struct Facet
    {
      SurfaceFacet side;
      /// The numbers of its nodes: grid[j * (degree_s + 1) + i] is that at the
      /// i-th Gauss-Lobatto point of s and the j-th of t, and trace likewise in
      /// its own degrees.
      std::vector<unsigned int> grid, trace;
    };

    /// A node of a grid that lies in the middle between two neighbouring nodes
    /// of another facet's edge, as where a solid is locally refined: functions
    /// that are continuous and linear between these have their mean there,
    ///   v(node) = (v(ends[0]) + v(ends[1])) / 2.
    struct HangingNode
    {
      unsigned int                node = 0;
      std::array<unsigned int, 2> ends{};
    };

    /// In the order of Body::surface_facets().
    std::vector<Facet> facets;
    /// How many different nodes the grids and the traces have.
    unsigned int n_grid = 0, n_trace = 0;
    /// Numbers of grid nodes. Beams have none.
    std::vector<HangingNode> hanging;

    /**
     * Adds the facet @p side, whose nodes have the numbers @p grid and @p trace
     * in the body, whatever these are, as long as the same node has the same
     * one. They are in the order of Facet::grid and Facet::trace; 64 bits, as
     * they may be products of numbers in the section and along the axis.
     */
    void
    add(const SurfaceFacet               &side,
        const std::vector<std::uint64_t> &grid,
        const std::vector<std::uint64_t> &trace);

    /// The node of a facet's grid that is at @p place, one of the body's; none
    /// if that is on no facet.
    std::optional<unsigned int>
    grid_node(const Location::Place &place) const;

    /// Adds a node that hangs in the middle of @p ends, by the numbers of grid
    /// nodes in the body; nothing if one of them is on no facet. After the
    /// facets are added.
    void
    add_hanging(const std::uint64_t                 node,
                const std::array<std::uint64_t, 2> &ends);

  private:
    /// The numbers in the body and those here.
    std::map<std::uint64_t, unsigned int>     grid_numbers, trace_numbers;
    std::multimap<unsigned int, unsigned int> facets_of_cell;
  };
} // namespace lamella

#endif
