// SPDX-License-Identifier: LGPL-2.1-or-later

// The mesh of a contact's points, and what its file says of them.

#include "fixtures.h"

#include <lamella/report/vtu.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(contact_surface)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /// A block of 2 x 1 LE-2 cells and two B4, at rest: 5 x 7 nodes on its top.
  std::unique_ptr<Structure>
  block()
  {
    Bodies bodies;
    bodies.push_back(std::make_unique<Beam>(
      "block",
      make_section(rectangle(2., 1., {0.}, 2),
                   EngineeringConstants::isotropic(1., 0.3),
                   2),
      make_axis(3., 2),
      Placement()));
    return std::make_unique<Structure>(std::move(bodies),
                                       std::vector<Support>{clamp("start")},
                                       std::vector<Load>());
  }



  /// What carries the points of @p contact, which are nodes of @p body.
  std::shared_ptr<const SlaveSurface>
  surface_of(const ContactInterface &contact, const Body &body)
  {
    std::vector<SlaveNode> nodes;
    for (const auto &point : contact.points)
      nodes.push_back({point.node, point.normal});
    return std::make_shared<const SlaveSurface>(
      make_nodal_slave_surface(body, contact.slave_surface, nodes, false));
  }



  /// Points on @p surface against a rigid plane 0.25 away that comes nearer by
  /// 0.5; those that @p keep refuses have no partner.
  ContactInterface
  against_a_plane(const Structure   &structure,
                  const std::string &surface,
                  const std::function<bool(const SurfacePoint &point)> &keep)
  {
    ContactInterface contact;
    contact.name          = "floor";
    contact.second_name   = "plane";
    contact.slave_surface = surface;
    for (const SurfacePoint &point :
         structure.bodies()[0]->surface_points(surface))
      if (keep(point))
        {
          GapConstraint row;
          row.initial_gap = 0.25;
          row.gap_rate    = -0.5;
          contact.rows.push_back(row);
          contact.points.push_back({point.position,
                                    point.position + 0.25 * point.normal,
                                    point.normal,
                                    point.area});
          contact.points.back().node = point.location;
        }
    contact.surface = surface_of(contact, *structure.bodies()[0]);
    return contact;
  }



  /// The numbers of the array @p name.
  std::vector<double>
  array_of(const VtuGrid &grid, const std::string &name)
  {
    for (const VtuArray &array : grid.at_points)
      if (array.name == name)
        return std::get<std::vector<double>>(array.values);
    BOOST_FAIL("no array " + name);
    return {};
  }
} // namespace

BOOST_AUTO_TEST_CASE(a_grid_of_nodes)
{
  const auto structure = block();
  const auto contact =
    against_a_plane(*structure, "top", [](const auto &) { return true; });
  const ContactSurface surface(contact, *structure);
  BOOST_TEST(contact.points.size() == 35u);
  BOOST_TEST(surface.quadrilaterals().size() == 24u);
  BOOST_TEST(surface.isolated_points().empty());
}



BOOST_AUTO_TEST_CASE(points_without_neighbors_stand_alone)
{
  // Without the column of nodes x = 1 the first and the last strip are left
  // (x from 0 to 0.5, from 1.5 to 2); of the row y = 0 only the corner x = 0.
  const auto structure = block();
  const auto contact =
    against_a_plane(*structure, "top", [](const SurfacePoint &p) {
      return std::abs(p.position[0] - 1.) > 0.1 &&
             (p.position[1] > 0.1 || p.position[0] < 0.1);
    });
  const ContactSurface surface(contact, *structure);
  BOOST_TEST(surface.quadrilaterals().size() == 2u * 5u);
  BOOST_REQUIRE(surface.isolated_points().size() == 1u);
  BOOST_TEST(contact.points[surface.isolated_points()[0]].first.norm() ==
             1.); // (0, 0, 1)
}



BOOST_AUTO_TEST_CASE(only_faces_of_the_surface)
{
  // Cells of one layer have nodes of top and bottom on all their faces; those
  // inside of the body and its sides are not in contact.
  const auto structure = block();
  auto       contact =
    against_a_plane(*structure, "top", [](const auto &) { return true; });
  const auto below =
    against_a_plane(*structure, "bottom", [](const auto &) { return true; });
  contact.rows.insert(contact.rows.end(), below.rows.begin(), below.rows.end());
  contact.points.insert(contact.points.end(),
                        below.points.begin(),
                        below.points.end());
  contact.slave_surface = "all";
  contact.surface       = surface_of(contact, *structure->bodies()[0]);
  const ContactSurface surface(contact, *structure);
  BOOST_TEST(surface.quadrilaterals().size() == 48u);
}



BOOST_AUTO_TEST_CASE(an_obstacle_that_moves)
{
  // The plane has come 0.4 nearer at load factor 0.8: g = 0.25 - 0.4.
  const auto structure = block();
  const auto contact =
    against_a_plane(*structure, "top", [](const auto &) { return true; });
  // A motion by 0.01 along x, and one force, of row 3.
  BlockVector u     = structure->zero();
  const auto  rigid = structure->bodies()[0]->rigid_motions(undisplaced);
  u.block(0).add(0.01, rigid[0]);
  std::vector<ContactRow> rows;
  for (unsigned int k = 0; k < contact.rows.size(); ++k)
    rows.push_back({contact.points[k],
                    contact.rows[k].initial_gap,
                    contact.rows[k].gap(u, 0.8),
                    k == 3 ? 6. : 0.});
  const VtuGrid without = ContactSurface(contact, *structure).grid(u, rows);
  for (const auto &array : without.at_points)
    BOOST_TEST(array.name != "shear");
  // It slips along y.
  for (unsigned int k = 0; k < rows.size(); ++k)
    rows[k].friction = {dealii::Tensor<1, 3>({0., k == 3 ? 1.5 : 0., 0.}),
                        k == 3,
                        0.1 * k,
                        0.2 * k};
  const VtuGrid grid = ContactSurface(contact, *structure).grid(u, rows);
  const auto shear = array_of(grid, "shear"), state = array_of(grid, "state"),
             slid       = array_of(grid, "slid"),
             dissipated = array_of(grid, "dissipated");
  const auto gap = array_of(grid, "gap"), force = array_of(grid, "force"),
             p       = array_of(grid, "pressure"),
             apart   = array_of(grid, "separation"),
             touches = array_of(grid, "status"),
             x       = std::get<std::vector<double>>(grid.points.values);
  BOOST_TEST(grid.types.size() == 24u);
  BOOST_REQUIRE(gap.size() == contact.rows.size());
  for (unsigned int k = 0; k < gap.size(); ++k)
    {
      const auto tolerance = boost::test_tools::tolerance(1e-12);
      BOOST_TEST(gap[k] == -0.15, tolerance);
      BOOST_TEST(x[3 * k] == contact.points[k].first[0] + 0.01, tolerance);
      BOOST_TEST(apart[3 * k + 2] == -0.15, tolerance);
      BOOST_TEST(force[k] == (k == 3 ? 6. : 0.));
      BOOST_TEST(p[k] == force[k] / contact.points[k].area, tolerance);
      BOOST_TEST(touches[k] == (k == 3 ? 1. : 0.));
      BOOST_TEST(state[k] == (k == 3 ? 2. : 0.));
      BOOST_TEST(shear[3 * k + 1] == 0.25 * p[k], tolerance);
      BOOST_TEST(slid[k] == 0.1 * k, tolerance);
      BOOST_TEST(dissipated[k] == 0.2 * k / contact.points[k].area, tolerance);
    }
}



BOOST_AUTO_TEST_CASE(points_of_the_second_side)
{
  // A coarse block on a fine one that is turned below it and carries the
  // points: its grid, on positions of the coarse one, is the mesh.
  const auto steel = EngineeringConstants::isotropic(1., 0.3);
  Bodies     bodies;
  bodies.push_back(
    std::make_unique<Beam>("coarse",
                           make_section(rectangle(6., 1.), steel, 2),
                           make_axis(6., 1),
                           Placement::from_directions({-3., -3., 1.5},
                                                      Point<3>(0., 1., 0.),
                                                      Point<3>(0., 0., 1.))));
  bodies.push_back(std::make_unique<Beam>(
    "fine",
    make_section(rectangle(2., 1., {0.}, 3), steel, 2),
    make_axis(3., 2),
    Placement::from_directions({-1., -1.5, 0.},
                               Point<3>(std::sin(0.3), std::cos(0.3), 0.),
                               Point<3>(0., 0., 1.))));
  const Structure structure(std::move(bodies),
                            {{"clamp",
                              {{0, Region::Kind::surface, "top", {}},
                               {1, Region::Kind::surface, "bottom", {}}},
                              {{0., 0., 0.}}}},
                            {});
  ContactPair     pair;
  pair.name        = "middle";
  pair.first       = {0, Region::Kind::surface, "bottom", {}};
  pair.second      = {1, Region::Kind::surface, "top", {}};
  pair.enforcement = Enforcement::penalty;
  pair.penalty     = {PenaltyKind::per_area, 1.};
  pair.slave_side  = SlaveSide::second;
  for (const Discretization discretization :
       {Discretization::node_to_surface, Discretization::surface_to_surface})
    {
      pair.discretization            = discretization;
      const ContactInterface contact = make_interface(pair, structure.bodies());
      BOOST_REQUIRE(contact.points_on_second);
      const ContactSurface surface(contact, structure);
      BOOST_TEST(contact.points.size() == 7u * 7u);
      BOOST_TEST(surface.quadrilaterals().size() == 6u * 6u);
      BOOST_TEST(surface.isolated_points().empty());
    }
}

BOOST_AUTO_TEST_SUITE_END()
