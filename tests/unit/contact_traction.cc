// SPDX-License-Identifier: LGPL-2.1-or-later

// The pressure of a contact between its points: its integral is the resultant
// of the rows, in all and strip by strip, whatever meshes, sections and bodies
// are; a uniform pressure is uniform on either side, and nothing beyond.

#include "contact_fixtures.h"

#include <lamella/contact/contact_patch.h>
#include <lamella/contact/contact_traction.h>

#include <deal.II/base/quadrature_lib.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(contact_traction)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  constexpr double lower_height = 0.5;



  /// int f dA over what carries @p traction, by a rule of its own.
  Tensor<1, 3>
  integral(const ContactTraction &traction,
           const std::function<Tensor<1, 3>(const Point<3> &, double)> &f)
  {
    const dealii::QGauss<2> rule(12);
    const auto             &facets = traction.surface()->facets();
    Tensor<1, 3>            sum;
    for (unsigned int k = 0; k < facets.size(); ++k)
      for (const Polygon &part : facets[k].parts)
        for (unsigned int c = 1; c + 1 < part.size(); ++c)
          for (unsigned int q = 0; q < rule.size(); ++q)
            {
              // The square collapsed onto the triangle.
              const double u           = rule.point(q)[0],
                           v           = (1. - u) * rule.point(q)[1];
              const Tensor<1, 2> along = part[c] - part[0],
                                 up    = part[c + 1] - part[0];
              const Point<2> st        = part[0] + u * along + v * up;
              const auto     place     = facets[k].map(st);
              const double   dA        = rule.weight(q) * (1. - u) *
                                (along[0] * up[1] - along[1] * up[0]) *
                                cross_product_3d(place.d_s, place.d_t).norm();
              sum += dA * f(place.position, traction.at({k, st}).pressure);
            }
    return sum;
  }



  /// Force and moment of @p forces in the rows of @p contact on the body with
  /// the number @p body, by the work of its rigid motions.
  ContactTraction::Resultant
  by_rows(const ContactInterface    &contact,
          const Bodies              &bodies,
          const unsigned int         body,
          const std::vector<double> &forces)
  {
    BlockVector f = zero(bodies);
    for (unsigned int k = 0; k < forces.size(); ++k)
      contact.rows[k].add_to(f, forces[k]);
    const auto                 rigid = bodies[body]->rigid_motions(undisplaced);
    ContactTraction::Resultant sum;
    for (unsigned int c = 0; c < 3; ++c)
      {
        sum.force[c]  = f.block(body) * rigid[c];
        sum.moment[c] = f.block(body) * rigid[3 + c];
      }
    return sum;
  }



  /// Forces that are not alike.
  std::vector<double>
  some_forces(const ContactInterface &contact)
  {
    std::vector<double> forces;
    for (unsigned int k = 0; k < contact.points.size(); ++k)
      forces.push_back(contact.points[k].area * (k % 3 == 0 ? 0. : 1. + k % 7));
    return forces;
  }



  /// That strips along all axes sum to all of @p traction.
  void
  check_strips(const ContactTraction  &traction,
               const ContactInterface &contact,
               const Bodies           &bodies)
  {
    const auto   whole = traction.resultant();
    const double size  = whole.force.norm();
    for (unsigned int axis = 0; axis < 3; ++axis)
      {
        const auto [low, high] = search_radius_along(contact.points, axis);
        ContactTraction::Resultant sum;
        double                     begin = low - 1.;
        for (const double share : {0.13, 0.2, 0.7, 3.})
          {
            const double end =
              low + share * (high - low) + (share > 1. ? 1. : 0.);
            const auto part =
              traction.resultant(ContactStrip{axis, begin, end});
            sum.force += part.force;
            sum.moment += part.moment;
            begin = end;
          }
        BOOST_TEST((sum.force - whole.force).norm() < 1e-12 * size);
        BOOST_TEST((sum.moment - whole.moment).norm() <
                   1e-12 * size * bodies[1]->bounding_box().center().norm() +
                     1e-12 * whole.moment.norm() + 1e-12 * size);
      }
  }



  /// That the integral of the pressure is the resultant of the rows, on flat
  /// surfaces, and that strips along all axes sum to it.
  void
  check_resultants(const ContactInterface &contact, const Bodies &bodies)
  {
    const std::vector<double> forces = some_forces(contact);
    const ContactTraction     traction(contact,
                                   dealii::make_array_view(forces),
                                   {});
    const auto                by_work = by_rows(contact, bodies, 1, forces);
    const double              size    = by_work.force.norm();
    const auto                whole   = traction.resultant();
    BOOST_TEST((whole.force - by_work.force).norm() < 1e-12 * size);
    const Tensor<1, 3> n = contact.points[0].normal;
    const Tensor<1, 3> by_pressure =
      integral(traction,
               [&n](const Point<3> &, const double p) { return p * n; });
    BOOST_TEST((by_pressure - by_work.force).norm() < 1e-12 * size);

    // With friction shears are in forces, those of strips among them.
    std::vector<Tensor<1, 3>> shears;
    Tensor<1, 3>              all;
    for (unsigned int k = 0; k < forces.size(); ++k)
      {
        shears.push_back(forces[k] * Point<3>(0.1 * (k % 3), -0.2, 0.1));
        all += shears.back();
      }
    const ContactTraction friction_violations(contact,
                                              dealii::make_array_view(forces),
                                              dealii::make_array_view(
                                                std::as_const(shears)));
    BOOST_TEST(
      (friction_violations.resultant().force - whole.force - all).norm() <
      1e-12 * size);
    check_strips(traction, contact, bodies);
    check_strips(friction_violations, contact, bodies);
  }



  /// A block on a larger one, turned by 25 degrees.
  Bodies
  rotated_blocks(const Placement &placement, const Theory &theory)
  {
    const double       angle  = 25. * dealii::numbers::PI / 180.;
    const Tensor<1, 3> axis   = Point<3>(std::sin(angle), std::cos(angle), 0.),
                       across = Point<3>(std::cos(angle), -std::sin(angle), 0.);
    const Point<3> middle(1.1, 1.4, lower_height);
    Bodies         bodies;
    bodies.push_back(
      make_beam("upper",
                rectangle(0.8, 0.7, {0.}, 2),
                theory,
                1.2,
                2,
                Placement::from_directions(
                  placement.to_scene(middle - 0.4 * across - 0.6 * axis),
                  placement.vector_to_scene(Point<3>(axis)),
                  placement.axes[2])));
    bodies.push_back(make_beam(
      "lower", rectangle(2., lower_height, {0.}, 3), theory, 3., 4, placement));
    return bodies;
  }
} // namespace



BOOST_AUTO_TEST_CASE(turned_grids)
{
  for (const Placement &placement : placements)
    for (const Theory &theory : {layer_wise(2), layer_wise(3), taylor(2)})
      for (const SlaveSide slave_side : {SlaveSide::first, SlaveSide::second})
        for (const Discretization discretization :
             {Discretization::surface_to_surface,
              Discretization::node_to_surface})
          {
            const Bodies bodies  = rotated_blocks(placement, theory);
            ContactPair  pair    = pair_of("bottom", "top", discretization);
            pair.slave_side      = slave_side;
            const auto interface = make_interface(pair, bodies);
            check_resultants(interface, bodies);
          }
}



BOOST_AUTO_TEST_CASE(uniform_on_either_side)
{
  // Surface to surface the pressure ends where the upper block does, inside of
  // the cells of the lower one.
  for (const Placement &placement : placements)
    for (const SlaveSide slave_side : {SlaveSide::first, SlaveSide::second})
      {
        const Bodies bodies = rotated_blocks(placement, layer_wise(2));
        ContactPair  pair =
          pair_of("bottom", "top", Discretization::surface_to_surface);
        pair.slave_side               = slave_side;
        const auto          interface = make_interface(pair, bodies);
        std::vector<double> forces;
        for (const auto &point : interface.points)
          forces.push_back(3. * point.area);
        const ContactTraction traction(interface,
                                       dealii::make_array_view(forces),
                                       {});
        const auto            p_at = [&](const double x, const double y) {
          return traction
            .on_line(placement.to_scene({x, y, lower_height}),
                     placement.axes[2],
                     0.01)
            .pressure;
        };
        const double c = std::cos(25. * dealii::numbers::PI / 180.),
                     s = std::sin(25. * dealii::numbers::PI / 180.);
        for (const double a : {-0.39, -0.1, 0.02, 0.39})
          for (const double b : {-0.59, 0.13, 0.3, 0.59})
            BOOST_TEST(std::abs(p_at(1.1 + a * c + b * s, 1.4 - a * s + b * c) -
                                3.) < 1e-10);
        for (const double a : {-0.41, 0.41})
          BOOST_TEST(p_at(1.1 + a * c, 1.4 - a * s) == 0.);
        for (const double b : {-0.61, 0.61})
          BOOST_TEST(p_at(1.1 + b * s, 1.4 + b * c) == 0.);
        // The part of the footprint beyond y' = 1.4, half of it.
        if (&placement == &placements[0])
          {
            const auto half = traction.resultant(ContactStrip{1, 1.4, 9.});
            BOOST_TEST(std::abs(half.force[2] + 3. * 0.48) < 1e-11);
          }
      }
}



BOOST_AUTO_TEST_CASE(nodes_of_a_smaller_face)
{
  // A punch on a wider block whose nodes it meets: areas are those of the
  // punch, and so is what presses.
  for (const Theory &theory : {layer_wise(2), layer_wise(3), taylor(3)})
    {
      Bodies bodies;
      bodies.push_back(make_beam("wide",
                                 rectangle(3., lower_height, {0.}, 3),
                                 theory,
                                 3.,
                                 3,
                                 Placement()));
      bodies.push_back(
        make_beam("punch",
                  rectangle(1., 0.5, {0.}),
                  theory,
                  1.,
                  1,
                  Placement::from_directions({1., 1., lower_height},
                                             Point<3>(0., 1., 0.),
                                             Point<3>(0., 0., 1.))));
      const auto interface =
        make_interface(pair_of("top", "bottom", Discretization::node_to_node),
                       bodies);
      check_resultants(interface, bodies);
      std::vector<double> forces;
      for (const auto &point : interface.points)
        forces.push_back(2. * point.area);
      const ContactTraction traction(interface,
                                     dealii::make_array_view(forces),
                                     {});
      const Tensor<1, 3>    up   = Point<3>(0., 0., 1.);
      const auto            p_at = [&](const double x, const double y) {
        return traction.on_line({x, y, lower_height}, up, 0.01).pressure;
      };
      BOOST_TEST(std::abs(p_at(1.01, 1.99) - 2.) < 1e-10);
      BOOST_TEST(std::abs(p_at(1.4, 1.2) - 2.) < 1e-10);
      BOOST_TEST(p_at(0.99, 1.5) == 0.);
      BOOST_TEST(p_at(1.5, 2.01) == 0.);
      const ContactPatch patch(traction);
      BOOST_TEST(std::abs(patch.width(0) - 1.) < 1e-13);
      BOOST_TEST(std::abs(patch.width(1) - 1.) < 1e-13);
      BOOST_TEST(std::abs(patch.pressure() - 2.) < 1e-12);
    }
}



BOOST_AUTO_TEST_CASE(ends_of_a_section_by_gmsh)
{
  // Hexagons on end, one on the other or on a wider block.
  const SectionFile hexagon{std::string(LAMELLA_SOURCE_DIR) +
                              "/prm/sections/hexagon.msh",
                            0.05,
                            {{"carbon", oriented_material}},
                            "Section s"};
  for (const Placement &placement : placements)
    for (const unsigned int degree : {1, 2})
      for (const Discretization discretization :
           {Discretization::node_to_node,
            Discretization::node_to_surface,
            Discretization::surface_to_surface})
        for (const bool same : {true, false})
          {
            if (!same && discretization == Discretization::node_to_node)
              continue;
            Bodies bodies;
            bodies.push_back(make_beam(
              "lower", hexagon, layer_wise(degree), 1., 1, placement));
            Placement above = placement;
            above.origin    = placement.to_scene(same ? Point<3>(0., 1., 0.) :
                                                     Point<3>(-2., 1., -2.1));
            bodies.push_back(
              same ?
                make_beam("upper", hexagon, layer_wise(degree), 1., 1, above) :
                make_beam("upper",
                          rectangle(4., 4.2, {0.}, 5),
                          layer_wise(degree),
                          1.,
                          1,
                          above));
            const auto interface =
              make_interface(pair_of("end", "start", discretization), bodies);
            check_resultants(interface, bodies);
          }
}



BOOST_AUTO_TEST_CASE(a_curved_surface)
{
  // A half disc on a plate: rows and pressure have the same sum, and strips
  // sum to it.
  for (const Discretization discretization :
       {Discretization::surface_to_surface, Discretization::node_to_surface})
    {
      Bodies bodies;
      bodies.push_back(make_beam("roller",
                                 HalfDisc{0.5, 75., 0.2, 4, oriented_material},
                                 layer_wise(2),
                                 1.,
                                 2,
                                 Placement()));
      const auto box = bodies[0]->bounding_box();
      bodies.push_back(
        make_beam("plate",
                  rectangle(2., 0.2, {0.}, 4),
                  layer_wise(2),
                  1.,
                  3,
                  Placement::from_directions({-1., 0., box.upper_bound(2)},
                                             Point<3>(0., 1., 0.),
                                             Point<3>(0., 0., 1.))));
      ContactPair pair = pair_of("arc", "bottom", discretization);
      pair.slave_side  = SlaveSide::first;
      const auto                interface = make_interface(pair, bodies);
      const std::vector<double> forces    = some_forces(interface);
      const ContactTraction     traction(interface,
                                     dealii::make_array_view(forces),
                                     {});
      double                    sum = 0.;
      for (const double force : forces)
        sum += force;
      const Tensor<1, 3> by_pressure =
        integral(traction, [](const Point<3> &, const double p) {
          return Tensor<1, 3>({p, 0., 0.});
        });
      BOOST_TEST(std::abs(by_pressure[0] - sum) < 1e-9 * sum);
      const auto by_work = by_rows(interface, bodies, 1, forces);
      BOOST_TEST((traction.resultant().force - by_work.force).norm() <
                 1e-12 * sum);
      Tensor<1, 3> parts;
      for (const double x : {-9., -0.1, 0.03, 0.05})
        parts += traction
                   .resultant(ContactStrip{0,
                                           x,
                                           x == -9.  ? -0.1 :
                                           x == -0.1 ? 0.03 :
                                           x == 0.03 ? 0.05 :
                                                       9.})
                   .force;
      BOOST_TEST((parts - by_work.force).norm() < 1e-9 * sum);
    }
}

BOOST_AUTO_TEST_SUITE_END()
