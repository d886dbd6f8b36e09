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
   * Connectivity of the facets of a surface: two facets share a node if the
   * meshes do, not if points coincide (as those of the lips of a slit).
   * Continuous functions on a surface, such as mortar multipliers, use it.
   *
   * Each facet has two Gauss-Lobatto grids, the first coordinate running
   * fastest: that of the expansion, (degree_s + 1) x (degree_t + 1), whose
   * nodes contact uses, and that of the trace, which determines the
   * displacement. Each has its own numbers, from 0 without gaps, by facets.
   * Refers to no body.
   */
  struct SurfaceTopology
  {
    struct Facet
    {
      SurfaceFacet side;
      /// Node numbers: grid[j * (degree_s + 1) + i] is at the i-th
      /// Gauss-Lobatto point of s and the j-th of t; trace likewise.
      std::vector<unsigned int> grid, trace;
    };

    /// A grid node in the middle between two neighbors on another facet's edge,
    /// as in a refined solid: v(node) = (v(ends[0]) + v(ends[1])) / 2.
    struct HangingNode
    {
      unsigned int                node = 0;
      std::array<unsigned int, 2> ends{};
    };

    /// Facets in the order of Body::surface_facets().
    std::vector<Facet> facets;
    /// Numbers of different nodes of the grids and of the traces.
    unsigned int n_grid = 0, n_trace = 0;
    /// Hanging nodes, by numbers of grid nodes. Beams have none.
    std::vector<HangingNode> hanging;

    /// Adds the facet @p side; @p grid and @p trace are unique numbers in the
    /// body, 64 bits for products of numbers in the section and along the axis.
    void
    add(const SurfaceFacet               &side,
        const std::vector<std::uint64_t> &grid,
        const std::vector<std::uint64_t> &trace);

    /// Returns the grid node of a facet at @p place; none if it is on no facet.
    std::optional<unsigned int>
    grid_node(const Location::Place &place) const;

    /// Adds a node that hangs between @p ends, body numbers, after all facets;
    /// no effect if one is on no facet.
    void
    add_hanging(const std::uint64_t                 node,
                const std::array<std::uint64_t, 2> &ends);

  private:
    /// Numbers here by numbers in the body.
    std::map<std::uint64_t, unsigned int>     grid_numbers, trace_numbers;
    std::multimap<unsigned int, unsigned int> facets_of_cell;
  };
} // namespace lamella

#endif
