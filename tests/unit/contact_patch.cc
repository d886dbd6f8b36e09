// SPDX-License-Identifier: LGPL-2.1-or-later

// What comes of gap rows: uniform pressure between blocks whose meshes do not
// match, forces on crossed beams, obstacles, overlaps, conflicts.
//
// The patch test: two blocks of one footprint, heights h_1 and h_2, a gap g_0
// apart, moved together by d, with sides that slide freely along walls. The
// stress is uniaxial and uniform, whatever Poisson's ratio, and with eps per
// area the pressure is p = (d - g_0) / ((h_1 + h_2) / E + 1 / eps).

#include "contact_fixtures.h"

#include <lamella/base/exceptions.h>
#include <lamella/body/fields.h>
#include <lamella/contact/assumptions.h>
#include <lamella/solve/checks.h>
#include <lamella/solve/nonlinear_solver.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

BOOST_AUTO_TEST_SUITE(contact_patch)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;
using dealii::numbers::PI;

namespace
{
  constexpr double E = 200., upper_height = 0.7, lower_height = 0.5, gap = 0.01,
                   moved = 0.03, eps = 900.;
  constexpr double pressure =
    (moved - gap) / ((upper_height + lower_height) / E + 1. / eps);

  using Kind = Region::Kind;



  /// Bodies in contact, solved.
  struct UnpairedContact
  {
    std::unique_ptr<Structure>    structure;
    std::vector<ContactInterface> contacts;
    State                         state;
    Checks                        checks;
  };

  UnpairedContact
  solve(Bodies                      bodies,
        const ContactPair          &contact,
        const std::vector<Support> &supports,
        const std::vector<Load>    &loads = {})
  {
    UnpairedContact result;
    result.contacts = {make_interface(contact, bodies)};
    result.structure =
      std::make_unique<Structure>(std::move(bodies), supports, loads);
    const auto  &rows = result.contacts[0].rows;
    LinearSystem system(linearized(*result.structure), rows);
    result.state  = NonlinearSolver(system).solve(1.).state;
    result.checks = check_state(
      system.tangent(), result.contacts, supports.size(), result.state, 1.);
    return result;
  }



  /// Blocks of the footprint 2 x 3 with 3 x 2 cells above and 2 x 3 below (2
  /// and 3 along the axis), or turned against each other.
  Bodies
  two_blocks(const Placement &placement, const Theory &theory, const double nu)
  {
    Placement above     = placement;
    above.origin        = placement.to_scene({0., 0., lower_height + gap});
    const auto material = EngineeringConstants::isotropic(E, nu);
    Bodies     bodies;
    bodies.push_back(make_beam("upper",
                               rectangle(2., upper_height, {0.}, 3),
                               theory,
                               3.,
                               2,
                               above,
                               material));
    bodies.push_back(make_beam("lower",
                               rectangle(2., lower_height, {0.}, 2),
                               theory,
                               3.,
                               3,
                               placement,
                               material));
    return bodies;
  }



  ContactPair
  blocks_contact(const Discretization discretization,
                 const SlaveSide      slave_side)
  {
    ContactPair contact = pair_of("bottom", "top", discretization);
    contact.slave_side  = slave_side;
    contact.penalty     = {PenaltyKind::per_area, eps};
    return contact;
  }



  /// The largest error of a point's pressure, relative.
  double
  pressure_error(const UnpairedContact &touching)
  {
    double worst = 0.;
    for (unsigned int k = 0; k < touching.contacts[0].rows.size(); ++k)
      worst =
        std::max(worst,
                 std::abs(touching.state.force[k] /
                            touching.contacts[0].points[k].area / pressure -
                          1.));
    return worst;
  }
} // namespace

BOOST_AUTO_TEST_CASE(uniform_pressure_through_meshes_that_do_not_match)
{
  for (const auto &[placement, nu] :
       {std::make_pair(placements[0], 0.), std::make_pair(placements[1], 0.3)})
    for (const Theory &theory : {layer_wise(2), layer_wise(3), taylor(2)})
      for (const SlaveSide slave_side : {SlaveSide::first, SlaveSide::second})
        {
          const UnpairedContact touching =
            solve(two_blocks(placement, theory, nu),
                  blocks_contact(Discretization::surface_to_surface,
                                 slave_side),
                  walls_and_press(moved));
          BOOST_TEST(pressure_error(touching) < 1e-9,
                     "nu " << nu << ": " << pressure_error(touching));
          // Penetration p / eps in every row, and the whole force.
          for (const GapConstraint &row : touching.contacts[0].rows)
            BOOST_TEST(std::abs(row.gap(touching.state.u, 1.) * eps / pressure +
                                1.) < 1e-9);
          BOOST_TEST((touching.checks.contacts[0].force +
                      6. * pressure * placement.axes[2])
                       .norm() < 1e-9 * pressure);
          // Uniform stress: along the placement's z in its own axes, so its
          // trace and its norm are both p.
          for (const unsigned int b : {0, 1})
            {
              const Body       &body = *touching.structure->bodies()[b];
              const FieldSample sample =
                body.sample(body.locate({placement.to_scene(
                              {0.77, 1.1, b == 0 ? 0.9 : 0.22})})[0][0],
                            touching.state.u.block(b));
              BOOST_TEST(std::abs(sample.ply_stress[2] / -pressure - 1.) <
                         1e-9);
              BOOST_TEST(std::abs(sample.ply_stress.norm() / pressure - 1.) <
                         1e-9);
            }
        }
}



BOOST_AUTO_TEST_CASE(uniform_pressure_without_penetration)
{
  // By `exact` the gap closes in every row, and displacement and stress are
  // those of p = (d - g_0) / ((h_1 + h_2) / E) everywhere. So are resultant and
  // center of pressure. Single forces are p A_i where they are unique: TE-2 has
  // three functions across for five or seven rows.
  constexpr double p  = (moved - gap) / ((upper_height + lower_height) / E),
                   nu = 0.3;
  for (const Placement &placement : {placements.back()})
    for (const Theory &theory : {layer_wise(2), layer_wise(3), taylor(2)})
      for (const SlaveSide slave_side : {SlaveSide::first, SlaveSide::second})
        {
          ContactPair contact =
            blocks_contact(Discretization::surface_to_surface, slave_side);
          contact.enforcement = Enforcement::exact;
          const UnpairedContact touching =
            solve(two_blocks(placement, theory, nu),
                  contact,
                  walls_and_press(moved));
          const KktResidual &kkt = touching.checks.contacts[0];
          BOOST_TEST((kkt.force + 6. * p * placement.axes[2]).norm() <
                     1e-9 * p);
          const Point<3> center = placement.to_body(kkt.center_of_pressure);
          BOOST_TEST(std::hypot(center[0] - 1., center[1] - 1.5) < 1e-9);
          BOOST_TEST(kkt.min_force >= 0.);
          for (const GapConstraint &row : touching.contacts[0].rows)
            BOOST_TEST(std::abs(row.gap(touching.state.u, 1.)) < 1e-9 * moved);

          double stress = 0., displacement = 0., single = 0.;
          for (const unsigned int b : {0, 1})
            {
              const Body &body = *touching.structure->bodies()[b];
              // The upper block's top, its fixed face, moves by d.
              const double fixed =
                b == 0 ? lower_height + gap + upper_height : 0.;
              for (const OutputCell &cell :
                   output_cells(body, 2, touching.state.u.block(b)))
                for (unsigned int k = 0; k < cell.samples.size(); ++k)
                  {
                    const FieldSample &sample = cell.samples[k];
                    const Point<3>     x = placement.to_body(cell.positions[k]);
                    const Tensor<1, 3> due = placement.vector_to_scene(
                      Point<3>(nu * p / E * x[0],
                               nu * p / E * x[1],
                               (b == 0 ? -moved : 0.) -
                                 p / E * (x[2] - fixed)));
                    displacement = std::max(displacement,
                                            (sample.displacement - due).norm());
                    stress =
                      std::max({stress,
                                std::abs(sample.ply_stress[2] / -p - 1.),
                                std::abs(sample.ply_stress.norm() / p - 1.)});
                  }
            }
          for (unsigned int k = 0; k < touching.contacts[0].rows.size(); ++k)
            single =
              std::max(single,
                       std::abs(touching.state.force[k] /
                                  (touching.contacts[0].points[k].area * p) -
                                1.));
          BOOST_TEST(stress < 1e-9);
          BOOST_TEST(displacement < 1e-9 * moved);
          if (theory.kind == Theory::Kind::LE)
            BOOST_TEST(single < 1e-9);
        }
}



BOOST_AUTO_TEST_CASE(node_to_surface_leaves_an_error)
{
  // Forces stand at points of the other side, where they are not in balance
  // with the shares of a uniform pressure: an error of the method, which
  // doc/theory/contact.md states.
  for (const auto &[slave_side, largest, resultant] :
       {std::make_tuple(SlaveSide::first, 0.2096, -0.0299),
        std::make_tuple(SlaveSide::second, 0.1311, -0.0075)})
    {
      const UnpairedContact touching =
        solve(two_blocks(Placement(), layer_wise(2), 0.),
              blocks_contact(Discretization::node_to_surface, slave_side),
              walls_and_press(moved));
      BOOST_TEST(std::abs(pressure_error(touching) - largest) < 1e-4);
      BOOST_TEST(
        std::abs(touching.checks.contacts[0].force[2] / (-6. * pressure) - 1. -
                 resultant) < 1e-4);
      // Forces and moments balance all the same.
      BOOST_TEST(touching.checks.force_balance < 1e-11);
    }
}



BOOST_AUTO_TEST_CASE(uniform_pressure_between_turned_grids)
{
  // The upper block is turned by 25 degrees. Uniform pressure p is the forces
  // p A_i in the rows: the load on the upper block, whose face lies all above
  // the lower one, is then that of a pressure on its bottom, and the work on
  // any displacement of the lower one is p times the integral of n . u over the
  // footprint, here for a polynomial of degree 2. Gaps of linear displacements
  // are those at the centroid of the weights.
  const double angle = 25. * PI / 180., p = 3.;
  for (const Placement &placement : placements)
    for (const Theory &theory : {layer_wise(2), layer_wise(3), taylor(2)})
      for (const SlaveSide slave_side : {SlaveSide::first, SlaveSide::second})
        {
          const Tensor<1, 3> axis =
                               Point<3>(std::sin(angle), std::cos(angle), 0.),
                             across =
                               Point<3>(std::cos(angle), -std::sin(angle), 0.);
          const Point<3> middle(1.1, 1.4, lower_height);
          Bodies         bodies;
          bodies.push_back(
            make_beam("upper",
                      rectangle(0.8, upper_height, {0.}, 2),
                      theory,
                      1.2,
                      2,
                      Placement::from_directions(
                        placement.to_scene(middle - 0.4 * across - 0.6 * axis),
                        placement.vector_to_scene(Point<3>(axis)),
                        placement.axes[2])));
          bodies.push_back(make_beam("lower",
                                     rectangle(2., lower_height, {0.}, 3),
                                     theory,
                                     3.,
                                     4,
                                     placement));
          const auto interface =
            make_interface(blocks_contact(Discretization::surface_to_surface,
                                          slave_side),
                           bodies);
          BlockVector f = zero(bodies), due = zero(bodies);
          for (unsigned int k = 0; k < interface.rows.size(); ++k)
            {
              BOOST_TEST(interface.rows[k].initial_gap == 0.);
              interface.rows[k].add_to(f, p * interface.points[k].area);
            }
          add_load(
            {"pressure", {{0, Kind::surface, "bottom", {}}}, {}, digits(p)},
            bodies,
            due);
          Vector difference = f.block(0);
          difference -= due.block(0);
          BOOST_TEST(difference.linfty_norm() <
                     1e-11 * due.block(0).linfty_norm());

          // u_n = (x - 1)^2 + 2 (x - 1) y over a rectangle with the half sides
          // a = 0.4 and b = 0.6, turned, about (1.1, 1.4): with the second
          // moments per area I_xx = a^2/3 c^2 + b^2/3 s^2 and
          // I_xy = (b^2 - a^2)/3 s c, the integral is
          // 4ab (0.01 + I_xx + 2 (0.1 1.4 + I_xy)).
          const double c = std::cos(angle), s = std::sin(angle), a = 0.4,
                       b    = 0.6;
          const double I_xx = (a * a * c * c + b * b * s * s) / 3.,
                       I_xy = (b * b - a * a) / 3. * s * c;
          const auto field  = [&placement](const Point<3> &x) {
            const Point<3> y = placement.to_body(x);
            return ((y[0] - 1.) * (y[0] - 1.) + 2. * (y[0] - 1.) * y[1]) *
                   placement.axes[2];
          };
          const RowReduction reduction(*bodies[1],
                                       0,
                                       prescribe_on_surface(*bodies[1], field),
                                       {"surface"});
          const double       work = -(f.block(1) * reduction.particular());
          BOOST_TEST(std::abs(work / (p * 4. * a * b *
                                      (0.01 + I_xx + 2. * (0.14 + I_xy))) -
                              1.) < 1e-10);
        }
}



BOOST_AUTO_TEST_CASE(crossed_beams)
{
  // The upper beam, clamped at both ends, is pressed onto the lower one.
  for (const double degrees : {90., 45.})
    for (const Discretization discretization :
         {Discretization::node_to_surface, Discretization::surface_to_surface})
      {
        const double       angle = degrees * PI / 180.;
        const Tensor<1, 3> axis =
                             Point<3>(std::sin(angle), std::cos(angle), 0.),
                           across =
                             Point<3>(std::cos(angle), -std::sin(angle), 0.);
        const Point<3> corner =
          Point<3>(0.25, 3., 0.4) - 0.15 * across - 2. * axis;
        Bodies bodies;
        bodies.push_back(make_beam(
          "upper",
          rectangle(0.3, 0.2, {0.}, 2),
          layer_wise(2),
          4.,
          7,
          Placement::from_directions(corner, axis, Point<3>(0., 0., 1.))));
        bodies.push_back(make_beam(
          "lower", rectangle(0.5, 0.4, {0.}, 3), layer_wise(2), 6., 10));
        ContactPair contact = pair_of("bottom", "top", discretization);
        contact.penalty     = {PenaltyKind::automatic, 1000.};
        const UnpairedContact touching = solve(
          std::move(bodies),
          contact,
          {{"clamps",
            {{0, Kind::surface, "ends", {}}, {1, Kind::surface, "ends", {}}},
            {{0., 0., 0.}}}},
          {{"weight", {{0, Kind::surface, "top", {}}}, {}, "0.01"}});
        const KktResidual &kkt = touching.checks.contacts[0];
        BOOST_TEST(kkt.active > 3);
        BOOST_TEST(kkt.force[2] < 0.);
        BOOST_TEST(std::abs(kkt.force[0]) < 1e-12 * std::abs(kkt.force[2]));
        BOOST_TEST(touching.checks.force_balance < 1e-9);
        BOOST_TEST(touching.checks.energy_balance < 1e-9);
        BOOST_TEST(kkt.law_error < 1e-9 * touching.state.u.linfty_norm());
      }
}



namespace
{
  std::shared_ptr<const Obstacle>
  make_floor(const Placement &placement, const double height)
  {
    auto floor          = std::make_shared<Obstacle>();
    floor->name         = "floor";
    floor->shape        = Obstacle::Shape::plane;
    floor->point        = placement.to_scene({7., -3., height});
    floor->direction    = placement.axes[2];
    floor->displacement = 0.02 * placement.axes[2];
    return floor;
  }
} // namespace



BOOST_AUTO_TEST_CASE(a_block_on_a_floor_that_rises)
{
  // The floor, 0.01 below, comes up by 0.02 against a block held at its top:
  // p = (0.02 - 0.01) / (h / E + 1 / eps).
  const double p = 0.01 / (upper_height / E + 1. / eps);
  for (const Placement &placement : placements)
    for (const Discretization discretization :
         {Discretization::node_to_surface, Discretization::surface_to_surface})
      {
        Bodies bodies;
        bodies.push_back(make_beam("block",
                                   rectangle(2., upper_height, {0.}, 2),
                                   layer_wise(2),
                                   3.,
                                   2,
                                   placement,
                                   EngineeringConstants::isotropic(E, 0.3)));
        ContactPair contact =
          blocks_contact(discretization, SlaveSide::automatic);
        contact.obstacle = make_floor(placement, -0.01);
        const UnpairedContact touching =
          solve(std::move(bodies),
                contact,
                {{"walls",
                  {{0, Kind::surface, "left", {}},
                   {0, Kind::surface, "start", {}},
                   {0, Kind::surface, "top", {}}},
                  {},
                  0.}});
        const ContactInterface &interface = touching.contacts[0];
        BOOST_TEST(!interface.second_body);
        BOOST_TEST(interface.second_name == "floor");
        double area = 0.;
        for (unsigned int k = 0; k < interface.rows.size(); ++k)
          {
            area += interface.points[k].area;
            BOOST_TEST(std::abs(interface.rows[k].initial_gap - 0.01) < 1e-13);
            BOOST_TEST(std::abs(interface.rows[k].gap_rate + 0.02) < 1e-15);
            BOOST_TEST(
              std::abs(touching.state.force[k] / interface.points[k].area / p -
                       1.) < 1e-9);
          }
        BOOST_TEST(std::abs(area - 6.) < 1e-12);
        // Obstacles that are reached by nothing.
        contact.search_distance = 0.009;
        BOOST_CHECK_THROW(make_interface(contact, touching.structure->bodies()),
                          InputError);
      }
}



BOOST_AUTO_TEST_CASE(a_roller_on_a_strip)
{
  // A rigid cylinder of radius 1 across a strip, 0.1 above. From the point at y
  // to that of the circle at sin a the averaged normal leans back by a/2:
  // y = sin a + t sin(a/2), t cos(a/2) = 1 - cos a + 0.1.
  for (const Placement &placement : placements)
    {
      Bodies bodies;
      bodies.push_back(make_beam("strip",
                                 rectangle(0.5, 0.2, {0.}, 4),
                                 layer_wise(2),
                                 2.,
                                 20,
                                 placement));
      auto roller         = std::make_shared<Obstacle>();
      roller->name        = "roller";
      roller->shape       = Obstacle::Shape::cylinder;
      roller->point       = placement.to_scene({3., 1., 1.3});
      roller->direction   = placement.axes[0];
      roller->radius      = 1.;
      ContactPair contact = pair_of("top", "", Discretization::node_to_surface);
      contact.obstacle    = roller;
      const auto interface = make_interface(contact, bodies);
      BOOST_TEST(interface.rows.size() > 100);
      for (unsigned int k = 0; k < interface.rows.size(); ++k)
        {
          const auto    &point = interface.points[k];
          const Point<3> hit   = placement.to_body(point.second);
          const double   a     = std::asin(hit[1] - 1.);
          const double   t     = interface.rows[k].initial_gap;
          BOOST_TEST(std::abs(t * std::cos(0.5 * a) - (1.1 - std::cos(a))) <
                     1e-12);
          BOOST_TEST(std::abs(placement.to_body(point.first)[1] - hit[1] -
                              t * std::sin(0.5 * a)) < 1e-12);
          BOOST_TEST(std::abs(point.angle - std::abs(a)) < 1e-10);
        }
    }
}



namespace
{
  void
  check_says(const std::function<void()>    &action,
             const std::vector<std::string> &fragments)
  {
    try
      {
        action();
        BOOST_ERROR("not refused: " + fragments[0]);
      }
    catch (const InputError &error)
      {
        const std::string message = error.what();
        for (const std::string &fragment : fragments)
          BOOST_TEST((message.find(fragment) != std::string::npos),
                     "'" << message << "' does not say '" << fragment << "'");
      }
  }
} // namespace



BOOST_AUTO_TEST_CASE(overlaps)
{
  // A wedge: the upper strip is tilted about x so that one end is 0.01 inside.
  const double slope = 0.03;
  Placement    below;
  below.origin[1] = -0.1;
  Bodies bodies;
  bodies.push_back(make_beam("upper",
                             rectangle(0.6, 0.2),
                             layer_wise(2),
                             1.,
                             3,
                             Placement::from_directions({0., 0., 0.19},
                                                        Point<3>(0., 1., slope),
                                                        Point<3>(0., 0., 1.))));
  bodies.push_back(
    make_beam("lower", rectangle(0.6, 0.2), layer_wise(2), 1.2, 2, below));
  ContactPair contact =
    pair_of("bottom", "top", Discretization::surface_to_surface);

  const auto smallest = [&] {
    double gap = 1.;
    for (const GapConstraint &row : make_interface(contact, bodies).rows)
      gap = std::min(gap, row.initial_gap);
    return gap;
  };
  BOOST_TEST(smallest() < -0.008);
  BOOST_TEST(smallest() > -0.01);
  contact.overclosure = Overclosure::adjust;
  BOOST_TEST(smallest() == 0.);
  contact.overclosure = Overclosure::refuse;
  check_says([&] { make_interface(contact, bodies); },
             {"Contact middle/Overclosure = error", "overlap", "(0", "0.19"});
  contact.discretization = Discretization::node_to_surface;
  check_says([&] { make_interface(contact, bodies); }, {"by up to 0.0100011"});
}



BOOST_AUTO_TEST_CASE(surfaces_that_look_away)
{
  // Whole surfaces: only the faces that look at each other pair, though tops
  // and bottoms are opposed through the bodies, too.
  const Bodies bodies = two_blocks(Placement(), layer_wise(2), 0.);
  for (const Discretization discretization :
       {Discretization::node_to_surface, Discretization::surface_to_surface})
    {
      const auto interface =
        make_interface(pair_of("all", "all", discretization), bodies);
      double area = 0.;
      for (unsigned int k = 0; k < interface.rows.size(); ++k)
        {
          area += interface.points[k].area;
          BOOST_TEST(std::abs(interface.rows[k].initial_gap - gap) < 1e-13);
        }
      BOOST_TEST(std::abs(area - 6.) < 1e-12);
      check_says(
        [&] {
          make_interface(pair_of("top", "bottom", discretization), bodies);
        },
        {"'top' in First lies 1.21 behind 'bottom' in Second",
         "[contact.surface-behind]"});
      // A block 0.6 deep in a block is no overlap to resolve.
      Bodies    inside = two_blocks(Placement(), layer_wise(2), 0.);
      Placement deep;
      deep.origin[2] = -0.6 + lower_height;
      inside[0]      = make_beam(
        "upper", rectangle(2., upper_height), layer_wise(2), 3., 2, deep);
      check_says(
        [&] {
          make_interface(pair_of("bottom", "top", discretization), inside);
        },
        {"lies 0.6 behind", "[contact.surface-behind]"});
    }
  check_says(
    [&] {
      make_interface(
        pair_of("left", "right", Discretization::surface_to_surface), bodies);
    },
    {"Contact middle", "[contact.no-pairs]"});
  ContactPair near = pair_of("bottom", "top", Discretization::node_to_surface);
  near.search_distance = 0.009;
  check_says([&] { make_interface(near, bodies); },
             {"within the search distance 0.009", "0.01 apart"});
}



BOOST_AUTO_TEST_CASE(conflicts)
{
  const Bodies bodies = two_blocks(Placement(), layer_wise(2), 0.);
  for (const Discretization discretization :
       {Discretization::node_to_surface, Discretization::surface_to_surface})
    {
      ContactPair all = pair_of("all", "all", discretization);
      all.name        = "all";
      const std::vector<ContactInterface> two{
        make_interface(pair_of("bottom", "top", discretization), bodies),
        make_interface(all, bodies)};
      check_says([&] { check_conflicts(two, bodies); },
                 {"Contact all",
                  "[contact.shared-points]",
                  "Contact middle",
                  "'upper'"});
      std::swap(all.first, all.second);
      const std::vector<ContactInterface> turned{two[0],
                                                 make_interface(all, bodies)};
      check_says([&] { check_conflicts(turned, bodies); }, {"Contact all"});
      check_conflicts({two[0]}, bodies);
    }
}



BOOST_AUTO_TEST_CASE(what_slides_is_told)
{
  // The upper block moves by 0.2 along x, against a spacing of points of the
  // root of the area.
  const Bodies bodies = two_blocks(Placement(), layer_wise(2), 0.);
  const auto   interface =
    make_interface(pair_of("bottom", "top", Discretization::node_to_surface),
                   bodies);
  BlockVector u = zero(bodies);
  u.block(0).add(0.2, bodies[0]->rigid_motions(undisplaced)[0]);
  u.block(1).add(0.7, bodies[1]->rigid_motions(undisplaced)[2]);
  std::vector<unsigned int> active{3, 4};
  const Sliding sliding = largest_sliding(interface, bodies, u, 1., active);
  BOOST_TEST(std::abs(sliding.distance - 0.2) < 1e-13);
  BOOST_TEST(std::abs(sliding.spacing -
                      std::sqrt(std::min(interface.points[3].area,
                                         interface.points[4].area))) < 1e-13);
  const auto notes = assumption_warnings(interface, bodies, u, 1., active);
  BOOST_REQUIRE(notes.size() == 1);
  BOOST_TEST((notes[0].find("is 0.2,") != std::string::npos));
  u.block(0) = 0.;
  BOOST_TEST(assumption_warnings(interface, bodies, u, 1., active).empty());
  BOOST_TEST(assumption_warnings(interface, bodies, u, 1., {}).empty());
}

BOOST_AUTO_TEST_SUITE_END()
