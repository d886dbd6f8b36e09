// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_surface_topology_h
#define lamella_body_surface_topology_h

#include <lamella/body/body.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Functions on the names of surfaces that every body has: `start` (y = 0),
  /// `end` (y = L), `ends` (both), `all` (ends and lateral surfaces).
  namespace surface_names
  {
    /// Returns "start" if @p at_start is true, otherwise "end".
    std::string
    end_name(const bool at_start);

    /// Returns true if @p surface is `all`: ends and lateral surfaces.
    bool
    is_whole_surface(const std::string &surface);

    /// Returns true if @p surface is `ends` or `all`, which combine surfaces.
    bool
    is_compound_surface(const std::string &surface);

    /// Returns true if the surface @p surface is @p part or contains it.
    bool
    covers(const std::string &surface, const std::string &part);
  } // namespace surface_names

  /// Computes the tributary area int N dA of a surface node with shape function
  /// N, and its mean normal along int N n dA, as sums over facets.
  class SurfaceNode
  {
  public:
    /// Sets the location of the node to that of @p at, a facet point at the
    /// node. Marks a corner if its facets' normals differ by 20 degrees or
    /// more.
    void
    meet(const SurfacePoint &at);

    /// Adds the area @p share [length^2] of a facet with the normal @p normal.
    void
    add(const double share, const dealii::Tensor<1, 3> &normal)
    {
      area += share;
      weighted += share * normal;
    }

    /// Distributes the area of this hanging node to the two nodes that
    /// constrain it, half to each; has_point() is false afterwards.
    void
    distribute_to_ends(SurfaceNode &one_end, SurfaceNode &other_end);

    /// Returns true if the node has a location, set by meet().
    bool
    has_point() const
    {
      return met;
    }

    /// Returns the node with area and mean normal. Requires has_point().
    SurfacePoint
    finished() const;

  private:
    double               area = 0.;
    dealii::Tensor<1, 3> weighted;
    bool                 met = false;
    SurfacePoint         point;
  };

  /// Facets (element faces) of a surface and the indices of their nodes, for
  /// continuous functions on the surface such as mortar multipliers. Facets
  /// share a node if their elements do, not if nodes merely coincide.
  ///
  /// Each facet has two Gauss-Lobatto grids, s running fastest: `grid` with
  /// (degree_s + 1) x (degree_t + 1) nodes, used by contact, and `trace`, whose
  /// nodes determine displacements. Node numbers of each grid begin at 0.
  struct SurfaceTopology
  {
    /// A facet with the numbers of its nodes.
    struct Facet
    {
      SurfaceFacet side; ///< Element face and its parameters s, t.
      /// Nodes for contact; entry j * (degree_s + 1) + i is at the i-th
      /// Gauss-Lobatto point of s and the j-th of t.
      std::vector<unsigned int> grid,
        trace; ///< Nodes of the displacement, ordered likewise.
    };

    /// A hanging node of `grid` in a locally refined solid, in the middle of an
    /// edge of another facet. Its value is the mean of the ends of this edge.
    struct HangingNode
    {
      unsigned int                node = 0; ///< Number of the hanging node.
      std::array<unsigned int, 2> ends{};   ///< Nodes at the ends of the edge.
    };

    /// All facets, in the order of surface_facets().
    std::vector<Facet> facets;
    /// Number of nodes of contact (Facet::grid) on the surface.
    unsigned int n_grid = 0, n_trace = 0; ///< Number of nodes of Facet::trace.
    /// Hanging nodes of the surface; empty for beams.
    std::vector<HangingNode> hanging;

    /// Adds the facet @p side. @p grid and @p trace are its nodes for contact
    /// and displacement, numbered by any unique integers.
    void
    add(const SurfaceFacet               &side,
        const std::vector<std::uint64_t> &grid,
        const std::vector<std::uint64_t> &trace);

    /// Returns the index of the contact node at @p place, or an empty optional.
    std::optional<unsigned int>
    grid_node(const Location::Place &place) const;

    /// Adds the hanging node @p node between @p ends, numbered as in add(), if
    /// all three are on the surface. Call after all facets are added.
    void
    add_hanging(const std::uint64_t                 node,
                const std::array<std::uint64_t, 2> &ends);

  private:
    /// Maps from node numbers of the body to node numbers of the surface, for
    /// the nodes of the geometry (grid) and of the displacements (trace).
    std::map<std::uint64_t, unsigned int>     grid_numbers, trace_numbers;
    std::multimap<unsigned int, unsigned int> facets_of_cell;
  };

  /// Returns the facets (element faces) of @p surface of @p body.
  std::vector<SurfaceFacet>
  surface_facets(const Body &body, const std::string &surface);
} // namespace lamella

#endif
