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
  /// Facets of a surface and numbers of their nodes, for continuous functions
  /// on the surface such as mortar multipliers. Facets share a node if their
  /// elements do; nodes that merely coincide (lips of a slit) are different.
  ///
  /// Each facet has two Gauss-Lobatto grids, s running fastest: `grid` with
  /// (degree_s + 1) x (degree_t + 1) nodes, used by contact, and `trace` of the
  /// trace degrees, which determines the displacement. Each grid has its own
  /// node numbers, from 0.
  struct SurfaceTopology
  {
    struct Facet
    {
      SurfaceFacet side;
      /// Node numbers: grid[j * (degree_s + 1) + i] is at the i-th
      /// Gauss-Lobatto point of s and the j-th of t; trace likewise.
      std::vector<unsigned int> grid, trace;
    };

    /// A hanging grid node in a locally refined solid, in the middle of an edge
    /// of another facet: v(node) = (v(ends[0]) + v(ends[1])) / 2.
    struct HangingNode
    {
      unsigned int                node = 0;
      std::array<unsigned int, 2> ends{};
    };

    /// Facets in the order of Body::surface_facets().
    std::vector<Facet> facets;
    /// Numbers of nodes of `grid` and of `trace` on the surface.
    unsigned int n_grid = 0, n_trace = 0;
    /// Hanging nodes; beams have none.
    std::vector<HangingNode> hanging;

    /// Adds the facet @p side with the nodes @p grid and @p trace, by node
    /// numbers of the body (any unique integers).
    void
    add(const SurfaceFacet               &side,
        const std::vector<std::uint64_t> &grid,
        const std::vector<std::uint64_t> &trace);

    /// Returns the number of the grid node at the point @p place, if any.
    std::optional<unsigned int>
    grid_node(const Location::Place &place) const;

    /// Adds the hanging node @p node between @p ends, by node numbers of the
    /// body, if all three are on the surface. Call after all facets are added.
    void
    add_hanging(const std::uint64_t                 node,
                const std::array<std::uint64_t, 2> &ends);

  private:
    /// Node numbers of the surface by node numbers of the body.
    std::map<std::uint64_t, unsigned int>     grid_numbers, trace_numbers;
    std::multimap<unsigned int, unsigned int> facets_of_cell;
  };
} // namespace lamella

#endif
