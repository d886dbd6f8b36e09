// SPDX-License-Identifier: LGPL-2.1-or-later

// What follows of how the facets of a surface hang together: its facets, its
// points, and those that fix the displacement.

#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/body/body.h>
#include <lamella/body/cell_grid.h>
#include <lamella/body/surface_topology.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <set>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Adds the integrals of the nodal functions over @p facet.
    void
    add_areas(const Body                   &body,
              const SurfaceTopology::Facet &facet,
              std::vector<SurfaceNode>     &nodes)
    {
      const unsigned int  degree = std::max({facet.side.degree_s,
                                             facet.side.degree_t,
                                             facet.side.trace_degree_s,
                                             facet.side.trace_degree_t});
      const auto          basis  = GaussLobattoBasis::of_degree;
      const QGauss<2>     gauss(degree + 2);
      std::vector<double> N;
      for (unsigned int q = 0; q < gauss.size(); ++q)
        {
          const SurfacePoint at =
            body.surface_point(facet.side, gauss.point(q));
          evaluate_on_grid(basis(facet.side.degree_s),
                           basis(facet.side.degree_t),
                           gauss.point(q),
                           N);
          for (unsigned int k = 0; k < N.size(); ++k)
            nodes[facet.grid[k]].add(N[k] * gauss.weight(q) * at.area,
                                     at.normal);
        }
    }
  } // namespace



  std::vector<SurfacePoint>
  Body::surface_points(const std::string &surface) const
  {
    const auto               basis    = GaussLobattoBasis::of_degree;
    const SurfaceTopology    topology = surface_topology(surface);
    std::vector<SurfaceNode> nodes(topology.n_grid);
    for (const SurfaceTopology::Facet &facet : topology.facets)
      {
        const SurfaceFacet         &side = facet.side;
        const std::vector<Point<2>> grid =
          grid_points(basis(side.degree_s), basis(side.degree_t));
        for (unsigned int k = 0; k < grid.size(); ++k)
          nodes[facet.grid[k]].meet(surface_point(side, grid[k]));
        add_areas(*this, facet, nodes);
      }
    for (const auto &[node, ends] : topology.hanging)
      nodes[node].distribute_to_ends(nodes[ends[0]], nodes[ends[1]]);

    std::vector<SurfacePoint> points;
    for (const SurfaceNode &node : nodes)
      if (node.has_point())
        points.push_back(node.finished());
    return points;
  }



  std::vector<Location>
  Body::constraint_points(const std::string &surface) const
  {
    const SurfaceTopology  topology = surface_topology(surface);
    std::set<unsigned int> hanging, seen;
    for (const SurfaceTopology::HangingNode &node : topology.hanging)
      hanging.insert(node.node);
    std::vector<Location> locations;
    for (const SurfaceTopology::Facet &facet : topology.facets)
      {
        const SurfaceFacet &side    = facet.side;
        const bool          is_grid = facet.grid.size() == facet.trace.size();
        const std::vector<Point<2>> trace =
          grid_points(GaussLobattoBasis::of_degree(side.trace_degree_s),
                      GaussLobattoBasis::of_degree(side.trace_degree_t));
        for (unsigned int k = 0; k < trace.size(); ++k)
          if (!(is_grid && hanging.count(facet.grid[k]) > 0) &&
              seen.insert(facet.trace[k]).second)
            locations.push_back(surface_point(side, trace[k]).location);
      }
    return locations;
  }



  std::vector<Location>
  Body::body_points() const
  {
    const CellGrid        grid(cells().degrees);
    std::vector<Location> locations;
    for (unsigned int cell = 0; cell < cells().n; ++cell)
      for (const Point<3> &unit : grid.nodes())
        locations.push_back(
          {position({cell, unit}), ply_at({cell, unit}).ply, {{cell, unit}}});
    return locations;
  }
} // namespace lamella
