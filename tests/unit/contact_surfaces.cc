// SPDX-License-Identifier: LGPL-2.1-or-later

// Surfaces as contact sees them: facets, rays, averaged normals, pairs.
// Geometry alone, nothing is solved; see contact_segments.cc for what surfaces
// have in common and contact_patch.cc for what comes of it.

#include "contact_fixtures.h"

#include <lamella/body/surface_topology.h>
#include <lamella/contact/mesh_surface.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <map>
#include <random>

BOOST_AUTO_TEST_SUITE(contact_surfaces)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;
using dealii::numbers::PI;

BOOST_AUTO_TEST_CASE(facets_make_up_the_surface)
{
  // A half disc of radius 0.5: pi/2 0.5 around, 1 flat, pi/8 at each end, times
  // the length 3, up to the interpolation of the arc; a laminate exactly.
  const std::map<std::string, double> of_laminate{{"top", 1.8},
                                                  {"bottom", 1.8},
                                                  {"left", 0.6},
                                                  {"right", 0.6},
                                                  {"start", 0.12},
                                                  {"end", 0.12},
                                                  {"ends", 0.24},
                                                  {"all", 5.04}},
    of_disc{{"arc", 1.5 * PI},
            {"flat", 3.},
            {"start", PI / 8.},
            {"end", PI / 8.},
            {"ends", PI / 4.},
            {"all", 3. + 1.5 * PI + PI / 4.}};
  for (const Placement &placement : {placements.back()})
    for (const Theory &theory : {layer_wise(2), layer_wise(3), taylor(2)})
      for (const auto &[shape, areas, tolerance] :
           {std::make_tuple(SectionShape(rectangle(0.6, 0.2, {0., 90.}, 3)),
                            of_laminate,
                            1e-13),
            std::make_tuple(SectionShape(
                              HalfDisc{0.5, 90., 0.1, 8, oriented_material}),
                            of_disc,
                            2e-4)})
        {
          const auto body = make_beam("body", shape, theory, 3., 2, placement);
          for (const std::string &surface : body->surfaces())
            {
              const dealii::QGauss<2> rule(4);
              double                  sum = 0.;
              for (const SurfaceFacet &facet : surface_facets(*body, surface))
                {
                  for (unsigned int q = 0; q < rule.size(); ++q)
                    sum += rule.weight(q) *
                           body->surface_point(facet, rule.point(q)).area;
                  for (unsigned int k = 0; k < 4; ++k)
                    BOOST_TEST(
                      body->surface_point(facet, Point<2>(k % 2, k / 2))
                        .position.distance(facet.corners[k]) < 1e-14);
                }
              BOOST_TEST(std::abs(sum / areas.at(surface) - 1.) < tolerance,
                         surface << ": " << sum);
            }
        }
}



BOOST_AUTO_TEST_CASE(facets_know_position_normal_and_trace)
{
  // Maps and traces are kept as polynomials of their own; they must be those of
  // the body, and the area density |dX/ds x dX/dt|.
  std::mt19937                           random(3);
  std::uniform_real_distribution<double> number(0., 1.);
  for (const Placement &placement : {placements.back()})
    for (const Theory &theory :
         {layer_wise(1), layer_wise(2), layer_wise(3), taylor(1), taylor(3)})
      for (const SectionShape &shape :
           {SectionShape(rectangle(0.6, 0.2, {0., 90.}, 3)),
            SectionShape(HalfDisc{0.5, 75., 0.1, 4, oriented_material})})
        {
          const auto body = make_beam("body", shape, theory, 3., 2, placement);
          const MeshSurface   surface(*body, "all");
          const Vector        u = any_displacement(*body);
          std::vector<double> trace;
          for (const MeshSurface::Facet &facet : surface.facets())
            {
              const Point<2>     st(number(random), number(random));
              const SurfacePoint point = body->surface_point(facet.side, st);
              const auto         place = facet.map(st);
              const Tensor<1, 3> n     = cross_product_3d(place.d_s, place.d_t);
              BOOST_TEST(place.position.distance(point.position) < 1e-13);
              BOOST_TEST(
                (surface.outward_normal(facet, place) - point.normal).norm() <
                1e-12);
              BOOST_TEST(std::abs(n.norm() / point.area - 1.) < 1e-11);

              surface.evaluate_trace(facet, st, trace);
              Tensor<1, 3> sum;
              for (unsigned int j = 0; j < trace.size(); ++j)
                sum +=
                  trace[j] *
                  displacement(*body,
                               surface.trace_location(facet.trace_nodes[j]),
                               u);
              BOOST_TEST((sum - displacement(*body, point.location, u)).norm() <
                         1e-10);
            }
        }
}



BOOST_AUTO_TEST_CASE(rays_against_closed_forms)
{
  std::mt19937                           random(5);
  std::uniform_real_distribution<double> number(-1., 1.);
  for (const Placement &placement : placements)
    {
      // Onto the top of a laminate, at z = 0.2, from above and from inside.
      const auto beam = make_beam(
        "beam", rectangle(0.6, 0.2, {0.}, 3), layer_wise(2), 3., 4, placement);
      const MeshSurface top(*beam, "top");
      for (unsigned int k = 0; k < 50; ++k)
        {
          const Point<3> projection(0.3 + 0.29 * number(random),
                                    1.5 + 1.49 * number(random),
                                    0.2);
          Tensor<1, 3>   d(
            Point<3>(0.4 * number(random), 0.4 * number(random), -1.));
          d /= d.norm();
          const double t   = 0.1 * number(random);
          const auto   hit = top.meet(placement.to_scene(projection - t * d),
                                    placement.vector_to_scene(Point<3>(d)),
                                    0.2);
          BOOST_REQUIRE(hit.has_value());
          BOOST_TEST(std::abs(hit->distance - t) < 1e-13);
          BOOST_TEST(hit->position.distance(placement.to_scene(projection)) <
                     1e-13);
          BOOST_TEST((hit->normal - placement.axes[2]).norm() < 1e-13);
          // Out of reach, and along the normal instead of against it.
          BOOST_TEST(!top.meet(placement.to_scene(projection - t * d),
                               placement.vector_to_scene(Point<3>(d)),
                               0.9 * std::abs(t)));
          BOOST_TEST(!top.meet(placement.to_scene(projection - t * d),
                               placement.vector_to_scene(Point<3>(-d)),
                               0.2));
        }
      BOOST_TEST(
        !top.meet(placement.to_scene({0.61, 1., 0.3}), -placement.axes[2], 1.));

      // Onto the arc of a half disc about (0.5, 0). The mesh interpolates it:
      // off by 3e-7 and, in the normal, 2e-5 rad (LE-4).
      const auto disc =
        make_beam("disc",
                  HalfDisc{0.5, 90., 0.05, 8, oriented_material},
                  layer_wise(4),
                  1.,
                  2,
                  placement);
      const MeshSurface arc(*disc, "arc");
      for (unsigned int k = 0; k < 50; ++k)
        {
          const double   angle = 0.5 * PI * (1. + 0.8 * number(random));
          const Point<3> projection(0.5 + 0.5 * std::cos(angle),
                                    0.5 + 0.49 * number(random),
                                    0.5 * std::sin(angle));
          Tensor<1, 3>   n(Point<3>(std::cos(angle), 0., std::sin(angle)));
          Tensor<1, 3>   d = -n + 0.3 * Tensor<1, 3>(Point<3>(number(random),
                                                            number(random),
                                                            number(random)));
          d /= d.norm();
          const double t   = 0.2 * number(random);
          const auto   hit = arc.meet(placement.to_scene(projection - t * d),
                                    placement.vector_to_scene(Point<3>(d)),
                                    0.3);
          // Of a chord through the arc the nearer end counts, and only the
          // entry looks against the ray.
          BOOST_REQUIRE(hit.has_value());
          BOOST_TEST(std::abs(hit->distance - t) < 1e-6);
          BOOST_TEST(
            (hit->normal - placement.vector_to_scene(Point<3>(n))).norm() <
            1e-4);
          // Exactly on the ray and on the body's own surface.
          BOOST_TEST(disc->surface_point(arc.facets()[hit->facet].side, hit->st)
                       .position.distance(
                         placement.to_scene(projection - t * d) +
                         hit->distance *
                           placement.vector_to_scene(Point<3>(d))) < 1e-13);
        }
    }
}



namespace
{
  /// Two half discs of radius 8, the upper one mirrored, @p gap apart.
  Bodies
  two_half_discs(const double gap, const Placement &placement)
  {
    const HalfDisc disc{8., 90., 0.2, 8, oriented_material};
    Bodies         bodies;
    bodies.push_back(make_beam("upper",
                               disc,
                               layer_wise(2),
                               1.,
                               1,
                               upside_down(placement, {16., 0., 16. + gap})));
    bodies.push_back(make_beam("lower", disc, layer_wise(2), 1., 1, placement));
    return bodies;
  }
} // namespace



BOOST_AUTO_TEST_CASE(mirrored_bodies_face_each_other_along_the_mirrors_normal)
{
  // To 40 degrees off the top, where normals are opposed to 80 degrees, the
  // limit is 60 (30 off the top).
  for (const Placement &placement : placements)
    {
      const Bodies      bodies = two_half_discs(0.1, placement);
      const MeshSurface lower(*bodies[1], "arc");
      unsigned int      found = 0;
      for (const SurfacePoint &point : bodies[0]->surface_points("arc"))
        {
          const auto facing =
            find_master_point(lower, point.position, point.normal, 16.);
          const double cosine = -point.normal * placement.axes[2];
          BOOST_TEST((facing.has_value() == (cosine > std::sqrt(0.75))),
                     "cosine " << cosine);
          if (!facing)
            continue;
          ++found;
          BOOST_TEST((facing->normal + placement.axes[2]).norm() < 1e-11);
          const Tensor<1, 3> d =
            placement.vector_to_body(facing->hit.position - point.position);
          BOOST_TEST(std::hypot(d[0], d[1]) < 1e-10);
          // 0.1 and twice the arc's height, as the mesh has it.
          const double depth =
            8.05 - placement.to_body(facing->hit.position)[2];
          BOOST_TEST(std::abs(facing->hit.distance - 2. * depth) < 1e-10);
        }
      BOOST_TEST(found > 20);
    }
}



BOOST_AUTO_TEST_CASE(far_points_meet_a_small_cylinder)
{
  // The averaged normal and the normal at the hit make the same angle phi / 2
  // with the line, from the point to R sin phi; gaps to 20 radii.
  const double R = 5.;
  for (const double gap : {1., 10., 35., 100.})
    for (const double share : {-0.9, -0.3, 0., 0.1, 0.5, 0.95})
      {
        const auto nose = std::make_shared<Obstacle>();
        nose->shape     = Obstacle::Shape::cylinder;
        nose->point     = Point<3>(0., 0., gap + R);
        nose->direction = Tensor<1, 3>({1., 0., 0.});
        nose->radius    = R;
        const Point<3> x(2., share * R, 0.);
        const auto     facing = find_master_point(ObstacleSurface(nose),
                                              x,
                                              Tensor<1, 3>({0., 0., 1.}),
                                              200.);
        BOOST_TEST_REQUIRE(facing.has_value());
        const Tensor<1, 3> d     = facing->hit.position - x;
        const double       angle = std::asin(facing->hit.position[1] / R);
        BOOST_TEST(d[0] == 0.);
        BOOST_TEST(std::abs(std::hypot(facing->hit.position[1],
                                       facing->hit.position[2] - gap - R) -
                            R) < 1e-11 * R);
        BOOST_TEST(std::abs(d[1] / d[2] + std::tan(angle / 2.)) < 1e-10);
        BOOST_TEST(std::abs(facing->hit.distance - d.norm()) < 1e-10 * gap);
      }
}



BOOST_AUTO_TEST_CASE(mirrored_bodies_pair_all_nodes)
{
  // All but the two lines where the arcs end, whose normals are parallel.
  for (const Placement &placement : placements)
    {
      const Bodies bodies = two_half_discs(0.1, placement);
      auto contact        = pair_of("arc", "arc", Discretization::node_to_node);
      contact.search_distance      = 20.;
      const ContactInterface there = make_interface(contact, bodies);
      const unsigned int     n     = bodies[0]->surface_points("arc").size();
      BOOST_TEST(there.unpaired == 8);
      BOOST_TEST(there.unpaired_second == 8);
      BOOST_TEST(there.rows.size() == n - 8);
      for (unsigned int k = 0; k < there.rows.size(); ++k)
        {
          BOOST_TEST((there.points[k].normal + placement.axes[2]).norm() <
                     1e-11);
          const double depth =
            8.05 - placement.to_body(there.points[k].second)[2];
          BOOST_TEST(std::abs(there.rows[k].initial_gap - 2. * depth) < 1e-11);
        }
    }
}



BOOST_AUTO_TEST_CASE(first_and_second_decide_signs_only)
{
  // Two strips with other cells, crossed at 20 degrees, and mirrored discs.
  for (const Placement &placement : {placements.back()})
    for (const bool discs : {false, true})
      for (const Discretization discretization :
           {Discretization::node_to_node,
            Discretization::node_to_surface,
            Discretization::surface_to_surface})
        {
          if (!discs && discretization == Discretization::node_to_node)
            continue;
          Bodies bodies;
          if (discs)
            bodies = two_half_discs(0.1, placement);
          else
            {
              bodies.push_back(
                make_beam("upper",
                          rectangle(0.6, 0.2, {0.}, 2),
                          layer_wise(2),
                          2.,
                          3,
                          Placement::from_directions(
                            placement.to_scene({0.1, 0.2, 0.3}),
                            placement.vector_to_scene(
                              Point<3>(std::sin(0.35), std::cos(0.35), 0.)),
                            placement.axes[2])));
              bodies.push_back(make_beam("lower",
                                         rectangle(0.6, 0.2, {0.}, 3),
                                         layer_wise(2),
                                         2.,
                                         3,
                                         placement));
            }
          auto contact = discs ? pair_of("arc", "arc", discretization) :
                                 pair_of("bottom", "top", discretization);
          const ContactInterface one = make_interface(contact, bodies);
          std::swap(contact.first, contact.second);
          const ContactInterface two = make_interface(contact, bodies);

          // The lower strip has the finer grid; of equal ones the body that
          // comes first carries the points.
          if (discretization != Discretization::node_to_node)
            {
              BOOST_TEST(one.points_on_second == !discs);
              BOOST_TEST(two.points_on_second == discs);
            }
          BOOST_REQUIRE(one.rows.size() == two.rows.size());
          BlockVector u = zero(bodies);
          for (unsigned int b = 0; b < 2; ++b)
            u.block(b) = any_displacement(*bodies[b], b);
          // By the gap that any displacement gives, since the order may differ.
          std::map<long, unsigned int> of_gap;
          for (unsigned int k = 0; k < two.rows.size(); ++k)
            of_gap[std::lround(1e8 * two.rows[k].gap(u, 1.))] = k;
          for (unsigned int k = 0; k < one.rows.size(); ++k)
            {
              const long key   = std::lround(1e8 * one.rows[k].gap(u, 1.));
              auto       other = of_gap.lower_bound(key - 1);
              BOOST_REQUIRE((other != of_gap.end() && other->first <= key + 1));
              const unsigned int l = other->second;
              BOOST_TEST(std::abs(one.rows[k].gap(u, 1.) -
                                  two.rows[l].gap(u, 1.)) < 1e-11);
              BOOST_TEST(std::abs(one.rows[k].initial_gap -
                                  two.rows[l].initial_gap) < 1e-11);
              BOOST_TEST(std::abs(one.points[k].area - two.points[l].area) <
                         1e-11);
              BOOST_TEST((one.points[k].normal + two.points[l].normal).norm() <
                         1e-11);
              BOOST_TEST(one.points[k].first.distance(two.points[l].second) <
                         1e-10);
              BOOST_TEST(one.points[k].second.distance(two.points[l].first) <
                         1e-10);
            }
        }
}

BOOST_AUTO_TEST_SUITE_END()
