// SPDX-License-Identifier: LGPL-2.1-or-later

// Pairs of points, tributary areas, penalties and the gap of a row: geometry
// alone, nothing is solved.

#include "entries.h"
#include "fixtures.h"

#include <lamella/base/exceptions.h>
#include <lamella/contact/pairing.h>
#include <lamella/contact/parameters.h>
#include <lamella/contact/search.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

BOOST_AUTO_TEST_SUITE(contact)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const EngineeringConstants isotropic =
    EngineeringConstants::isotropic(10., 0.25);

  /// 5 x 4 points 0.2 apart at the height @p z, moved by @p shift, with the
  /// normal (0, 0, @p up). Each has the area 0.04, whose root is 0.2.
  std::vector<SurfacePoint>
  plate(const double z, const double up, const Tensor<1, 3> &shift = {})
  {
    std::vector<SurfacePoint> points;
    for (unsigned int i = 0; i < 5; ++i)
      for (unsigned int j = 0; j < 4; ++j)
        {
          SurfacePoint point;
          point.position  = Point<3>(0.2 * i, 0.2 * j, z) + shift;
          point.normal[2] = up;
          point.area      = 0.04;
          points.push_back(point);
        }
    return points;
  }



  // Two beams of 0.6 x 0.2, length 2, the upper one 0.05 above the lower.
  constexpr double width = 0.6, height = 0.2, length = 2., distance = 0.05;

  Bodies
  two_beams(const Placement   &lower        = Placement(),
            const unsigned int axis_degree  = 3,
            const unsigned int degree       = 2,
            const unsigned int cells_across = 2,
            const unsigned int elements     = 2)
  {
    Placement upper = lower;
    upper.origin    = lower.to_scene({0., 0., height + distance});
    Bodies bodies;
    for (const auto &[name, placement] :
         {std::make_pair("upper", upper), std::make_pair("lower", lower)})
      bodies.push_back(std::make_unique<Beam>(
        name,
        make_section(rectangle(width, height, {0.}, cells_across),
                     isotropic,
                     degree),
        make_axis(length, elements, axis_degree),
        placement));
    return bodies;
  }



  ContactPair
  between(const std::string &first,
          const std::string &second,
          const Penalty     &penalty = {PenaltyKind::per_node, 1.})
  {
    ContactPair contact;
    contact.name           = "middle";
    contact.first          = {0, Region::Kind::surface, first, {}};
    contact.second         = {1, Region::Kind::surface, second, {}};
    contact.discretization = Discretization::node_to_node;
    contact.enforcement    = Enforcement::penalty;
    contact.penalty        = penalty;
    return contact;
  }



  BlockVector
  zero(const Bodies &bodies)
  {
    return BlockVector(
      std::vector<dealii::types::global_dof_index>{bodies[0]->n_dofs(),
                                                   bodies[1]->n_dofs()});
  }



  void
  check_refused(const ContactPair              &contact,
                const Bodies                   &bodies,
                const std::vector<std::string> &says)
  {
    try
      {
        make_interface(contact, bodies);
        BOOST_ERROR("not refused: " + says[0]);
      }
    catch (const InputError &error)
      {
        const std::string message = error.what();
        for (const std::string &fragment : says)
          BOOST_TEST((message.find(fragment) != std::string::npos),
                     "'" << message << "' does not say '" << fragment << "'");
      }
  }
} // namespace

BOOST_AUTO_TEST_CASE(facing_plates_pair)
{
  // The first 0.03 above the second and looking down: gap
  // (X_2 - X_1) . n = (-0.03)(-1) = 0.03; 0.03 below the other way round, that
  // is a penetration.
  for (const double z : {0.03, -0.03})
    {
      const auto    first = plate(z, -1.), second = plate(0., 1.);
      const Pairing pairing = pair_node_to_node(first, second, 1e-6);
      BOOST_TEST(pairing.pairs.size() == 20);
      BOOST_TEST(pairing.unpaired == 0);
      BOOST_TEST(std::abs(pairing.nearest_distance - 0.03) < 1e-15);
      BOOST_TEST(pairing.smallest_offset < 1e-15);
      for (const PointPair &pair : pairing.pairs)
        {
          BOOST_TEST(pair.first == pair.second);
          BOOST_TEST(std::abs(pair.initial_gap - z) < 1e-15);
          BOOST_TEST((pair.normal - Point<3>(0., 0., -1.)).norm() == 0.);
        }
    }

  // Moved by a whole spacing: a row of 4 on each side has no partner.
  const Pairing moved = pair_node_to_node(plate(0.03, -1.),
                                          plate(0., 1., Point<3>(0.2, 0., 0.)),
                                          1e-6);
  BOOST_TEST(moved.pairs.size() == 16);
  BOOST_TEST(moved.unpaired == 4);
  for (const PointPair &pair : moved.pairs)
    BOOST_TEST(pair.first == pair.second + 4);
}



BOOST_AUTO_TEST_CASE(plates_between_each_others_nodes)
{
  // Half a spacing, 0.1, sideways at a distance of 0.03.
  const Pairing pairing =
    pair_node_to_node(plate(0.03, -1.),
                      plate(0., 1., Point<3>(0.1, 0., 0.)),
                      1e-6);
  BOOST_TEST(pairing.pairs.empty());
  BOOST_TEST(pairing.unpaired == 20);
  BOOST_TEST(std::abs(pairing.nearest_distance - std::sqrt(0.01 + 0.0009)) <
             1e-15);
  BOOST_TEST(std::abs(pairing.smallest_offset - 0.1) < 1e-15);
}



BOOST_AUTO_TEST_CASE(plates_that_look_the_same_way)
{
  for (const double up : {1., -1.})
    {
      const Pairing pairing =
        pair_node_to_node(plate(0.03, up), plate(0., up), 1e-6);
      BOOST_TEST(pairing.pairs.empty());
      BOOST_TEST(pairing.unpaired == 20);
      BOOST_TEST(std::abs(pairing.nearest_distance - 0.03) < 1e-15);
      BOOST_TEST(pairing.smallest_offset == std::numeric_limits<double>::max());
    }
}



BOOST_AUTO_TEST_CASE(tolerance_of_the_offset)
{
  // 0.01 times the root of the area is 0.002.
  for (const auto &[offset, pairs] :
       {std::make_pair(0.0019, 20u), std::make_pair(0.0021, 0u)})
    for (const Tensor<1, 3> &shift :
         {Point<3>(offset, 0., 0.), Point<3>(0., -offset, 0.)})
      {
        const Pairing pairing =
          pair_node_to_node(plate(0.03, -1.), plate(0., 1., shift), 0.01);
        BOOST_TEST(pairing.pairs.size() == pairs);
        BOOST_TEST(pairing.unpaired == 20 - pairs);
        // The gap is along the normal, not the distance.
        for (const PointPair &pair : pairing.pairs)
          BOOST_TEST(std::abs(pair.initial_gap - 0.03) < 1e-15);
      }
}



BOOST_AUTO_TEST_CASE(twins_on_an_edge)
{
  // Where two surfaces of the second body meet it has two nodes at one place;
  // the one that looks back is the partner.
  auto second = plate(0., 1.);
  for (SurfacePoint &point : second)
    point.normal = Point<3>(1., 0., 0.);
  const auto facing = plate(0., 1.);
  second.insert(second.end(), facing.begin(), facing.end());
  const Pairing pairing = pair_node_to_node(plate(0.03, -1.), second, 1e-6);
  BOOST_TEST(pairing.pairs.size() == 20);
  for (const PointPair &pair : pairing.pairs)
    BOOST_TEST(pair.second == pair.first + 20);
}



BOOST_AUTO_TEST_CASE(nearest_points)
{
  const PointSearch search({{0., 0., 0.}, {1., 0., 0.}, {0., 3., 0.}});
  BOOST_TEST(search.nearest({0.9, 0., 0.}, 2) ==
               (std::vector<unsigned int>{1, 0}),
             boost::test_tools::per_element());
  BOOST_TEST(search.nearest({0., 2., 5.}, 5) ==
               (std::vector<unsigned int>{2, 0, 1}),
             boost::test_tools::per_element());
}



BOOST_AUTO_TEST_CASE(tributary_areas)
{
  // 0.6 x 2 above and below, 0.2 x 2 beside, 0.6 x 0.2 at the ends.
  const std::map<std::string, double> areas{{"top", 1.2},
                                            {"bottom", 1.2},
                                            {"left", 0.4},
                                            {"right", 0.4},
                                            {"start", 0.12},
                                            {"end", 0.12},
                                            {"ends", 0.24},
                                            {"all", 3.44}};
  for (const unsigned int degree : {1, 2, 3})
    for (const unsigned int axis_degree : {1, 2, 3})
      {
        const Bodies bodies = two_beams(Placement(), axis_degree, degree);
        BOOST_TEST(bodies[0]->surfaces().size() == areas.size());
        for (const std::string &surface : bodies[0]->surfaces())
          {
            double sum = 0.;
            for (const SurfacePoint &p : bodies[0]->surface_points(surface))
              {
                BOOST_TEST(p.area > 0.);
                sum += p.area;
              }
            BOOST_TEST(std::abs(sum - areas.at(surface)) < 1e-13,
                       surface << ": " << sum);
          }
      }

  // By hand: L9 over the width 0.6 (Simpson) and one B4 over the length 2
  // (1/12, 5/12): corner 0.1 2/12, middle of an edge 0.1 10/12, ...
  const Bodies bodies = two_beams(Placement(), 3, 2, 1, 1);
  for (const SurfacePoint &p : bodies[0]->surface_points("top"))
    {
      const bool middle = std::abs(p.position[0] - 0.3) < 1e-9;
      const bool end    = p.position[1] < 1e-9 || p.position[1] > 2. - 1e-9;
      BOOST_TEST(std::abs(p.area - (middle ? 0.4 : 0.1) *
                                     (end ? 2. / 12. : 10. / 12.)) < 1e-15);
      BOOST_TEST((p.normal - Point<3>(0., 0., 1.)).norm() < 1e-14);
      // E = 10, nu = 0.25: lambda + 2 mu = 12; the cell is the height deep.
      BOOST_TEST(std::abs(p.normal_modulus - 12.) < 1e-12);
      BOOST_TEST(std::abs(p.depth - height) < 1e-14);
    }
}



BOOST_AUTO_TEST_CASE(penalty_of_a_row)
{
  // E A / h: 6 0.5 / 0.1 = 30 and 8 0.3 / 0.2 = 12.
  const LocalStiffness first{6., 0.5, 0.1}, second{8., 0.3, 0.2};
  const Penalty        automatic{PenaltyKind::automatic, 1000.};
  BOOST_TEST(std::abs(row_penalty(automatic, first, second) - 12000.) < 1e-9);
  BOOST_TEST(std::abs(row_penalty(automatic, second, first) - 12000.) < 1e-9);
  BOOST_TEST(row_penalty({PenaltyKind::per_node, 7.}, first, second) == 7.);
  // 7 per area times the first's 0.5.
  BOOST_TEST(row_penalty({PenaltyKind::per_area, 7.}, first, second) == 3.5);
}



BOOST_AUTO_TEST_CASE(penalties_of_an_interface)
{
  const Bodies bodies = two_beams();
  const auto   sum    = [&bodies](const Penalty &penalty) {
    double s = 0.;
    for (const GapConstraint &row :
         make_interface(between("bottom", "top", penalty), bodies).rows)
      s += row.penalty;
    return s;
  };
  // 5 x 7 nodes; per area: 3 times 1.2; automatic: 12 A / 0.2 of each row, 72
  // in all, times the multiple 10.
  BOOST_TEST(std::abs(sum({PenaltyKind::per_node, 3.}) - 105.) < 1e-10);
  BOOST_TEST(std::abs(sum({PenaltyKind::per_area, 3.}) - 3.6) < 1e-12);
  BOOST_TEST(std::abs(sum({PenaltyKind::automatic, 10.}) - 720.) < 1e-9);
}



BOOST_AUTO_TEST_CASE(gap_of_a_row)
{
  // The first (upper) looks down, n = (0, 0, -1): moving the second up by 0.01
  // closes the gap by 0.01, moving the first up opens it, sideways nothing.
  // In a placement along other axes n is minus the body's z.
  for (const Placement &placement :
       {Placement(),
        Placement::from_directions({0.3, 0., 0.1},
                                   Point<3>(1., 2., 0.5),
                                   Point<3>(0., 0.2, 1.))})
    {
      const Bodies           bodies = two_beams(placement);
      const ContactInterface interface =
        make_interface(between("bottom", "top"), bodies);
      BOOST_TEST(interface.rows.size() == 35); // 2 L9 across, 2 B4 along
      BOOST_TEST(interface.unpaired == 0);
      BOOST_TEST(interface.first_body == 0);
      BOOST_TEST(*interface.second_body == 1);
      const Tensor<1, 3> n = -placement.axes[2];

      const auto gaps = [&](const unsigned int  body,
                            const Tensor<1, 3> &translation) {
        BlockVector u       = zero(bodies);
        const auto  motions = bodies[body]->rigid_motions(undisplaced);
        for (unsigned int c = 0; c < 3; ++c)
          u.block(body).add(translation[c], motions[c]);
        std::vector<double> result;
        for (const GapConstraint &row : interface.rows)
          result.push_back(row.gap(u, 1.));
        return result;
      };
      const auto check = [&](const std::vector<double> &found,
                             const double               due) {
        for (const double gap : found)
          BOOST_TEST(std::abs(gap - due) < 1e-13);
      };
      check(gaps(1, Tensor<1, 3>()), 0.05);
      check(gaps(1, 0.01 * placement.axes[2]), 0.04);
      check(gaps(1, 0.07 * placement.axes[2]), -0.02);
      check(gaps(1, 0.3 * placement.axes[0]), 0.05);
      check(gaps(1, -0.4 * placement.axes[1]), 0.05);
      check(gaps(0, 0.01 * placement.axes[2]), 0.06);
      const Tensor<1, 3> any = Point<3>(0.01, -0.02, 0.03);
      check(gaps(1, any), 0.05 + n * any);
      check(gaps(0, any), 0.05 - n * any);

      // Tilting the second about its own x through its center lifts y by
      // (y - 1) per rad. The points lie where the report says.
      BlockVector u       = zero(bodies);
      const auto  motions = bodies[1]->rigid_motions(undisplaced);
      for (unsigned int c = 0; c < 3; ++c)
        u.block(1).add(0.02 * placement.axes[0][c], motions[3 + c]);
      for (unsigned int k = 0; k < interface.rows.size(); ++k)
        {
          const auto  &p = interface.points[k];
          const double y = placement.to_body(p.second)[1];
          BOOST_TEST(std::abs(interface.rows[k].gap(u, 1.) - 0.05 +
                              0.02 * (y - 1.)) < 1e-13);
          BOOST_TEST((p.normal - n).norm() < 1e-13);
          BOOST_TEST((p.first + 0.05 * n - p.second).norm() < 1e-13);
        }
    }
}



BOOST_AUTO_TEST_CASE(force_of_a_row)
{
  // A force lambda in the row pushes the bodies apart: lambda n on the second,
  // -lambda n on the first, with equal and opposite moments about any point.
  const Bodies           bodies = two_beams();
  const ContactInterface interface =
    make_interface(between("bottom", "top"), bodies);
  for (unsigned int k = 0; k < interface.rows.size(); k += 9)
    {
      BlockVector f = zero(bodies);
      interface.rows[k].add_to(f, 4.);
      const Tensor<1, 3> force = Point<3>(0., 0., -4.);
      for (const unsigned int body : {0, 1})
        {
          const Tensor<1, 3> due = (body == 1 ? 1. : -1.) * force;
          const Point<3>     x =
            body == 1 ? interface.points[k].second : interface.points[k].first;
          const Tensor<1, 3> moment =
            cross_product_3d(x - bodies[body]->center(), due);
          const auto motions = bodies[body]->rigid_motions(undisplaced);
          for (unsigned int c = 0; c < 3; ++c)
            {
              BOOST_TEST(std::abs(f.block(body) * motions[c] - due[c]) < 1e-13);
              BOOST_TEST(std::abs(f.block(body) * motions[3 + c] - moment[c]) <
                         1e-13);
            }
        }
    }
}



BOOST_AUTO_TEST_CASE(surfaces_that_do_not_pair)
{
  const Bodies bodies = two_beams();
  check_refused(between("botom", "top"),
                bodies,
                {"Contact middle", "no surface 'botom'", "'bottom'"});
  check_refused(between("bottom", "roof"),
                bodies,
                {"Contact middle", "'lower'", "no surface 'roof'"});
  // The bottoms look the same way, 0.25 apart.
  check_refused(between("bottom", "bottom"),
                bodies,
                {"Contact middle", "[contact.no-pairs]", "0.25"});
  // Top and bottom the wrong way round face each other through both bodies,
  // 0.2 + 0.05 + 0.2 behind: that is no contact.
  check_refused(between("top", "bottom"), bodies, {"Contact middle", "0.45 "});

  // The second one moved by a tenth sideways: the columns of nodes of L9 are
  // 0.15 apart, so the nearest are 0.05 off.
  Bodies    apart = two_beams();
  Placement moved;
  moved.origin = Point<3>(0.1, 0., 0.);
  apart[1]     = std::move(two_beams(moved)[1]);
  check_refused(between("bottom", "top"),
                apart,
                {"[contact.no-pairs]", "0.0707107", "0.05"});
}



BOOST_AUTO_TEST_CASE(entries_of_a_contact)
{
  const std::vector<std::string> bodies{"upper", "lower"};
  auto                           plane = std::make_shared<Obstacle>();
  plane->name                          = "floor";
  const Obstacles obstacles{plane};
  const auto      read = [&](const Settings &changes) {
    Settings settings{{"First", "upper: bottom"}, {"Second", "lower: top"}};
    settings.insert(settings.end(), changes.begin(), changes.end());
    return parsed<ContactParameters>(
      "Contact c", settings, std::string("c"), bodies, obstacles);
  };
  const ContactPair plain = read({});
  BOOST_TEST(plain.name == "c");
  BOOST_TEST(plain.first.body == 0);
  BOOST_TEST(plain.second.surface == "top");
  BOOST_TEST((plain.discretization == Discretization::automatic));
  BOOST_TEST((plain.penalty.kind == PenaltyKind::automatic));
  BOOST_TEST(plain.penalty.value == 1e6);
  BOOST_TEST(!plain.search_distance);
  const ContactPair chosen = read({{"Discretization", "surface to surface"},
                                   {"Enforcement", "augmented lagrangian"},
                                   {"Slave side", "second"},
                                   {"Overclosure", "error"},
                                   {"Penalty", "900"},
                                   {"Penalty per", "node"},
                                   {"Search distance", "0.5"},
                                   {"Tolerance", "0.25"},
                                   {"Friction", "0.3"}});
  BOOST_TEST(chosen.friction == 0.3);
  BOOST_TEST((chosen.discretization == Discretization::surface_to_surface));
  BOOST_TEST((chosen.enforcement == Enforcement::augmented_lagrangian));
  BOOST_TEST((chosen.slave_side == SlaveSide::second));
  BOOST_TEST((chosen.overclosure == Overclosure::refuse));
  BOOST_TEST((chosen.penalty.kind == PenaltyKind::per_node));
  BOOST_TEST(chosen.penalty.value == 900.);
  BOOST_TEST(chosen.search_distance.value() == 0.5);
  BOOST_TEST(chosen.tolerance == 0.25);
  const ContactPair on_floor = read({{"Second", "floor"},
                                     {"Discretization", "node to surface"},
                                     {"Friction", ""}});
  BOOST_TEST(on_floor.obstacle == plane);
  BOOST_TEST(on_floor.friction == 0.);

  // What is refused, each with the entry that is wrong.
  for (const auto &[entry, value] : Settings{{"First", ""},
                                             {"First", "floor"},
                                             {"First", "uper: bottom"},
                                             {"Second", "floor: top"},
                                             {"Second", "flor"},
                                             {"Discretization", "mortar"},
                                             {"Enforcement", ""},
                                             {"Slave side", "third"},
                                             {"Overclosure", "refuse"},
                                             {"Penalty", "-1"},
                                             {"Penalty", ""},
                                             {"Penalty per", "length"},
                                             {"Search distance", "0"},
                                             {"Tolerance", "0.5"},
                                             {"Friction", "-0.3"},
                                             {"Friction", "11"},
                                             {"Friction", "some"}})
    BOOST_CHECK_EXCEPTION(read({{entry, value}}),
                          InputError,
                          [path = "Contact c/" + entry](const InputError &e) {
                            return e.path() == path;
                          });
  // An obstacle has no nodes; a body does not touch itself.
  const auto of = [](const std::string &path) {
    return [path](const InputError &error) { return error.path() == path; };
  };
  BOOST_CHECK_EXCEPTION(read({{"Second", "floor"},
                              {"Discretization", "node to node"}}),
                        InputError,
                        of("Contact c/Discretization"));
  BOOST_CHECK_EXCEPTION(read({{"Second", "upper: top"}}),
                        InputError,
                        of("Contact c"));
}



BOOST_AUTO_TEST_CASE(entries_of_an_obstacle)
{
  const auto read = [](const Settings &settings) {
    return parsed<ObstacleParameters>("Obstacle o",
                                      settings,
                                      std::string("o"),
                                      3u);
  };
  const auto plane = read({{"Shape", "plane"},
                           {"Through", "1, 2, 3"},
                           {"Normal", "0, 3, 4"},
                           {"u", "0, 0, -1"}});
  BOOST_TEST((plane->shape == Obstacle::Shape::plane));
  BOOST_TEST(plane->point.distance({1., 2., 3.}) == 0.);
  BOOST_TEST((plane->direction - Point<3>(0., 0.6, 0.8)).norm() < 1e-15);
  BOOST_TEST(plane->displacement[2] == -1.);
  const auto roller = read({{"Shape", "cylinder"}, {"Radius", "2"}});
  BOOST_TEST(roller->radius == 2.);
  BOOST_TEST(roller->direction[0] == 1.);

  for (const auto &[settings, entry] :
       std::vector<std::pair<Settings, std::string>>{
         {{}, "Shape"},
         {{{"Shape", "sphere"}}, "Shape"},
         {{{"Shape", "plane"}, {"Through", "1, 2"}}, "Through"},
         {{{"Shape", "plane"}, {"Normal", "0, 0, 0"}}, "Normal"},
         {{{"Shape", "plane"}, {"Radius", "1"}}, "Radius"},
         {{{"Shape", "cylinder"}}, "Radius"},
         {{{"Shape", "cylinder"}, {"Radius", "0"}}, "Radius"},
         {{{"Shape", "plane"}, {"u", "0, 0, down"}}, "u"}})
    BOOST_CHECK_EXCEPTION(read(settings),
                          InputError,
                          [path =
                             "Obstacle o/" + entry](const InputError &error) {
                            return error.path() == path;
                          });
}

BOOST_AUTO_TEST_SUITE_END()
