// SPDX-License-Identifier: LGPL-2.1-or-later

// What facets of a surface share, by the body's numbers. Where a body has no
// slit that is the same as being at one place, which is how it is checked.

#include "contact_fixtures.h"
#include "solid_fixtures.h"

#include <lamella/body/facet_map.h>
#include <lamella/body/surface_topology.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(surface_topology)

using namespace lamella;
using dealii::Point;

namespace
{
  /// The points of the Gauss-Lobatto grid of @p degrees on @p facet.
  std::vector<Point<3>>
  grid_points(const Body         &body,
              const SurfaceFacet &facet,
              const unsigned int  degree_s,
              const unsigned int  degree_t)
  {
    const auto &s = GaussLobattoBasis::of_degree(degree_s),
               &t = GaussLobattoBasis::of_degree(degree_t);
    std::vector<Point<3>> points;
    for (unsigned int j = 0; j < t.size(); ++j)
      for (unsigned int i = 0; i < s.size(); ++i)
        points.push_back(
          body.surface_point(facet, {s.point(i), t.point(j)}).position);
    return points;
  }



  /// The places of each number; one number, one place, and the other way round.
  void
  check_one_to_one(const std::vector<std::pair<unsigned int, Point<3>>> &nodes,
                   const unsigned int                                    n)
  {
    std::vector<std::optional<Point<3>>> places(n);
    for (const auto &[number, x] : nodes)
      {
        BOOST_REQUIRE(number < n);
        if (places[number])
          BOOST_TEST(places[number]->distance(x) < 1e-10);
        places[number] = x;
      }
    for (unsigned int a = 0; a < n; ++a)
      {
        BOOST_REQUIRE(places[a].has_value());
        for (unsigned int b = 0; b < a; ++b)
          BOOST_TEST(places[a]->distance(*places[b]) > 1e-6);
      }
  }



  void
  check_shared(const Body &body, const std::string &surface)
  {
    const SurfaceTopology topology = body.surface_topology(surface);
    std::vector<std::pair<unsigned int, Point<3>>> grid, trace;
    for (const SurfaceTopology::Facet &facet : topology.facets)
      {
        const SurfaceFacet &side = facet.side;
        const auto at = grid_points(body, side, side.degree_s, side.degree_t);
        const auto of_trace =
          grid_points(body, side, side.trace_degree_s, side.trace_degree_t);
        BOOST_REQUIRE(at.size() == facet.grid.size());
        BOOST_REQUIRE(of_trace.size() == facet.trace.size());
        for (unsigned int k = 0; k < at.size(); ++k)
          grid.emplace_back(facet.grid[k], at[k]);
        for (unsigned int k = 0; k < of_trace.size(); ++k)
          trace.emplace_back(facet.trace[k], of_trace[k]);
      }
    check_one_to_one(grid, topology.n_grid);
    check_one_to_one(trace, topology.n_trace);
  }
} // namespace

BOOST_AUTO_TEST_CASE(nodes_of_beams)
{
  for (const Theory &theory :
       {layer_wise(1), layer_wise(2), layer_wise(3), layer_wise(4), taylor(3)})
    for (const SectionShape &shape :
         {SectionShape(rectangle(0.6, 0.2, {0., 90.}, 3)),
          SectionShape(HalfDisc{0.5, 75., 0.1, 4, oriented_material})})
      {
        const auto body =
          make_beam("body", shape, theory, 3., 2, placements.back());
        for (const std::string &surface : body->surfaces())
          check_shared(*body, surface);
      }
}



BOOST_AUTO_TEST_CASE(nodes_of_solids)
{
  for (const unsigned int degree : {1, 2})
    for (const SolidRefinement &refinement :
         {SolidRefinement(), around_a_corner})
      {
        const Solid solid("solid",
                          one_material(),
                          axis_mesh(1.3, 2),
                          tilted,
                          degree,
                          refinement);
        for (const std::string &surface : solid.surfaces())
          check_shared(solid, surface);
      }
}



BOOST_AUTO_TEST_CASE(hanging_nodes)
{
  // A corner of 3 x 3 x 2 cells divided once: on the surface the refined cell
  // has three faces, each with two edges towards coarse ones. Their points are
  // the middles of what they hang between.
  for (const unsigned int degree : {1, 2})
    {
      const Solid           solid("solid",
                        one_material(),
                        axis_mesh(1.3, 2),
                        tilted,
                        degree,
                        around_a_corner);
      const SurfaceTopology topology = solid.surface_topology("all");
      std::vector<Point<3>> places(topology.n_grid);
      for (const SurfaceTopology::Facet &facet : topology.facets)
        {
          const auto at = grid_points(solid, facet.side, degree, degree);
          for (unsigned int k = 0; k < at.size(); ++k)
            places[facet.grid[k]] = at[k];
        }
      BOOST_TEST(!topology.hanging.empty());
      std::set<unsigned int> hanging;
      for (const auto &[node, ends] : topology.hanging)
        {
          hanging.insert(node);
          const Point<3> middle =
            places[ends[0]] + 0.5 * (places[ends[1]] - places[ends[0]]);
          BOOST_TEST(places[node].distance(middle) < 1e-12);
        }
      // Every node of a facet that lies on an edge of another one without
      // being its node hangs.
      unsigned int between = 0;
      for (unsigned int k = 0; k < places.size(); ++k)
        {
          bool lies_on_an_edge = false;
          for (const SurfaceTopology::Facet &facet : topology.facets)
            for (const auto &[a, b] :
                 {std::make_pair(0u, 1u), {2u, 3u}, {0u, 2u}, {1u, 3u}})
              {
                const auto  &x = facet.side.corners;
                const double s = ((places[k] - x[a]) * (x[b] - x[a])) /
                                 (x[b] - x[a]).norm_square();
                const bool is_own =
                  std::count(facet.grid.begin(), facet.grid.end(), k) > 0;
                lies_on_an_edge =
                  lies_on_an_edge ||
                  (!is_own && s > 0.01 && s < 0.99 &&
                   places[k].distance(x[a] + s * (x[b] - x[a])) < 1e-9);
              }
          between += lies_on_an_edge;
          BOOST_TEST(lies_on_an_edge == (hanging.count(k) > 0));
        }
      BOOST_TEST(between == hanging.size());
    }
}



BOOST_AUTO_TEST_CASE(lips_of_a_slit)
{
  // Two cells side by side that share one vertex of their common side: the
  // other one is there twice, so a slit opens between them.
  auto                        section = std::make_shared<SectionMesh>();
  const std::vector<Point<2>> vertices{
    {0., 0.}, {1., 0.}, {0., 1.}, {1., 1.}, {1., 1.}, {2., 0.}, {2., 1.}};
  std::vector<dealii::CellData<2>> cells(2);
  cells[0].vertices = {0, 1, 2, 3};
  cells[1].vertices = {1, 5, 4, 6};
  section->mesh.create_triangulation(vertices, cells, dealii::SubCellData());
  section->plies      = one_material()->plies;
  section->boundaries = {{0, "rim"}};

  for (const unsigned int degree : {1, 2, 3})
    {
      const Beam            beam("beam",
                      make_section(section, layer_wise(degree)),
                      make_axis(3., 2),
                      tilted);
      const SurfaceTopology topology = beam.surface_topology("rim");
      // Around: 8 sides of degree nodes, one vertex shared; along: 2 B4. By
      // place there were degree lines of nodes fewer.
      BOOST_TEST(topology.facets.size() == 16);
      BOOST_TEST(topology.n_grid == (8 * degree - 1) * 7);
    }
}

BOOST_AUTO_TEST_SUITE_END()
