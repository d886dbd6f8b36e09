// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/body/surface_topology.h>

#include <cmath>

namespace lamella
{
  using namespace dealii;

  std::string
  surface_names::end_name(const bool at_start)
  {
    return at_start ? "start" : "end";
  }



  bool
  surface_names::is_whole_surface(const std::string &surface)
  {
    return surface == "all";
  }



  bool
  surface_names::is_compound_surface(const std::string &surface)
  {
    return surface == "ends" || is_whole_surface(surface);
  }



  bool
  surface_names::covers(const std::string &surface, const std::string &part)
  {
    return surface == part || is_whole_surface(surface) ||
           (surface == "ends" && (part == "start" || part == "end"));
  }



  void
  SurfaceNode::meet(const SurfacePoint &at)
  {
    const double cos_corner = std::cos(20. * numbers::PI / 180.);
    if (!met)
      {
        point        = at;
        point.corner = false;
      }
    else if (at.normal * point.normal < cos_corner)
      point.corner = true;
    met = true;
  }



  void
  SurfaceNode::distribute_to_ends(SurfaceNode &one_end, SurfaceNode &other_end)
  {
    for (SurfaceNode *end : {&one_end, &other_end})
      {
        end->area += 0.5 * area;
        end->weighted += 0.5 * weighted;
      }
    met = false;
  }



  SurfacePoint
  SurfaceNode::finished() const
  {
    SurfacePoint result = point;
    result.area         = area;
    result.normal       = weighted / weighted.norm();
    return result;
  }



  void
  SurfaceTopology::add(const SurfaceFacet               &side,
                       const std::vector<std::uint64_t> &grid,
                       const std::vector<std::uint64_t> &trace)
  {
    const auto numbered = [](const std::vector<std::uint64_t>      &nodes,
                             std::map<std::uint64_t, unsigned int> &numbers) {
      std::vector<unsigned int> result;
      for (const std::uint64_t node : nodes)
        result.push_back(
          numbers.emplace(node, static_cast<unsigned int>(numbers.size()))
            .first->second);
      return result;
    };
    facets_of_cell.emplace(side.cell, facets.size());
    facets.push_back(
      {side, numbered(grid, grid_numbers), numbered(trace, trace_numbers)});
    n_grid  = grid_numbers.size();
    n_trace = trace_numbers.size();
  }



  namespace
  {
    /// The node of a grid of @p n nodes that is nearest to @p t in [0, 1].
    unsigned int
    nearest(const double t, const unsigned int degree)
    {
      const GaussLobattoBasis &nodes = GaussLobattoBasis::of_degree(degree);
      unsigned int             k     = 0;
      while (k < degree &&
             std::abs(nodes.point(k + 1) - t) < std::abs(nodes.point(k) - t))
        ++k;
      return k;
    }
  } // namespace



  std::optional<unsigned int>
  SurfaceTopology::grid_node(const Location::Place &place) const
  {
    constexpr double rounding = arithmetic::same_in_element;
    const auto [begin, end]   = facets_of_cell.equal_range(place.cell);
    for (auto it = begin; it != end; ++it)
      {
        const Facet               &facet = facets[it->second];
        const SurfaceFacet        &side  = facet.side;
        const dealii::Tensor<1, 3> d     = place.unit - side.origin;
        const double               s = d * side.along_s, t = d * side.along_t;
        if ((d - s * side.along_s - t * side.along_t).norm() < rounding)
          return facet.grid[nearest(t, side.degree_t) * (side.degree_s + 1) +
                            nearest(s, side.degree_s)];
      }
    return std::nullopt;
  }



  void
  SurfaceTopology::add_hanging(const std::uint64_t                 node,
                               const std::array<std::uint64_t, 2> &ends)
  {
    const auto at = grid_numbers.find(node), a = grid_numbers.find(ends[0]),
               b = grid_numbers.find(ends[1]), none = grid_numbers.end();
    if (at != none && a != none && b != none)
      hanging.push_back({at->second, {{a->second, b->second}}});
  }



  std::vector<SurfaceFacet>
  surface_facets(const Body &body, const std::string &surface)
  {
    std::vector<SurfaceFacet> facets;
    for (const SurfaceTopology::Facet &facet :
         body.surface_topology(surface).facets)
      facets.push_back(facet.side);
    return facets;
  }
} // namespace lamella
