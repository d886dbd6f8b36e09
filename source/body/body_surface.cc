// SPDX-License-Identifier: LGPL-2.1-or-later

// What follows of how the facets of a surface hang together: its facets, its
// points, and those that fix the displacement.

#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/body/body.h>
#include <lamella/body/cell_grid.h>
#include <lamella/body/surface_topology.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace lamella
{
  using namespace dealii;

  std::vector<SurfaceFacet>
  Body::surface_facets(const std::string &surface) const
  {
    std::vector<SurfaceFacet> facets;
    for (const SurfaceTopology::Facet &facet : surface_topology(surface).facets)
      facets.push_back(facet.side);
    return facets;
  }



  namespace
  {
    /// (s, t) of each node of a grid of these degrees, s running fastest.
    std::vector<Point<2>>
    grid_of(const unsigned int degree_s, const unsigned int degree_t)
    {
      const GaussLobattoBasis &s = GaussLobattoBasis::of_degree(degree_s),
                              &t = GaussLobattoBasis::of_degree(degree_t);
      std::vector<Point<2>> points;
      for (unsigned int j = 0; j < t.size(); ++j)
        for (unsigned int i = 0; i < s.size(); ++i)
          points.emplace_back(s.point(i), t.point(j));
      return points;
    }



    /// The nodal functions of the grid of @p facet at @p st.
    std::vector<double>
    functions_of(const SurfaceFacet &facet, const Point<2> &st)
    {
      std::array<double, GaussLobattoBasis::max_size> s, t, unused;
      GaussLobattoBasis::of_degree(facet.degree_s)
        .evaluate(st[0], s.data(), unused.data());
      GaussLobattoBasis::of_degree(facet.degree_t)
        .evaluate(st[1], t.data(), unused.data());
      std::vector<double> N;
      for (unsigned int j = 0; j <= facet.degree_t; ++j)
        for (unsigned int i = 0; i <= facet.degree_s; ++i)
          N.push_back(s[i] * t[j]);
      return N;
    }



    /// A node of a surface: what its facets add up to.
    struct NodeOfFacets
    {
      double       area = 0.;
      Tensor<1, 3> normal;
      bool         corner   = false;
      bool         is_there = false;
      SurfacePoint point;
    };



    /// Takes the place of node @p node from one of its facets, @p point.
    void
    meet(const SurfacePoint &point, NodeOfFacets &node)
    {
      const double cos_corner = std::cos(20. * numbers::PI / 180.);
      if (!node.is_there)
        node.point = point;
      else if (point.normal * node.point.normal < cos_corner)
        node.corner = true;
      node.is_there = true;
    }



    /// Adds the integrals of the nodal functions over @p facet.
    void
    add_areas(const Body                   &body,
              const SurfaceTopology::Facet &facet,
              std::vector<NodeOfFacets>    &nodes)
    {
      const unsigned int degree = std::max({facet.side.degree_s,
                                            facet.side.degree_t,
                                            facet.side.trace_degree_s,
                                            facet.side.trace_degree_t});
      const QGauss<2>    gauss(degree + 2);
      for (unsigned int q = 0; q < gauss.size(); ++q)
        {
          const SurfacePoint at =
            body.surface_point(facet.side, gauss.point(q));
          const std::vector<double> N =
            functions_of(facet.side, gauss.point(q));
          for (unsigned int k = 0; k < N.size(); ++k)
            {
              const double share = N[k] * gauss.weight(q) * at.area;
              nodes[facet.grid[k]].area += share;
              nodes[facet.grid[k]].normal += share * at.normal;
            }
        }
    }
  } // namespace



  std::vector<SurfacePoint>
  Body::surface_points(const std::string &surface) const
  {
    const SurfaceTopology     topology = surface_topology(surface);
    std::vector<NodeOfFacets> nodes(topology.n_grid);
    for (const SurfaceTopology::Facet &facet : topology.facets)
      {
        const SurfaceFacet         &side = facet.side;
        const std::vector<Point<2>> grid =
          grid_of(side.degree_s, side.degree_t);
        for (unsigned int k = 0; k < grid.size(); ++k)
          meet(surface_point(side, grid[k]), nodes[facet.grid[k]]);
        add_areas(*this, facet, nodes);
      }
    for (const SurfaceTopology::HangingNode &hanging : topology.hanging)
      {
        NodeOfFacets &node = nodes[hanging.node];
        for (const unsigned int end : hanging.ends)
          {
            nodes[end].area += 0.5 * node.area;
            nodes[end].normal += 0.5 * node.normal;
          }
        node.is_there = false;
      }

    std::vector<SurfacePoint> points;
    for (NodeOfFacets &node : nodes)
      if (node.is_there)
        {
          node.point.area   = node.area;
          node.point.normal = node.normal / node.normal.norm();
          node.point.corner = node.corner;
          points.push_back(node.point);
        }
    return points;
  }



  std::vector<Location>
  Body::fixing_points(const std::string &surface) const
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
          grid_of(side.trace_degree_s, side.trace_degree_t);
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
