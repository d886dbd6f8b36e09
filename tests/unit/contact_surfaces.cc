// SPDX-License-Identifier: LGPL-2.1-or-later

// Surfaces as contact sees them: facets, rays, averaged normals, segments and
// weighted gaps. Geometry alone, nothing is solved; see contact_patch.cc for
// what comes of it.

#include "contact_fixtures.h"

#include <lamella/base/exceptions.h>
#include <lamella/contact/mesh_surface.h>
#include <lamella/contact/segments.h>
#include <lamella/contact/weighted_gaps.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <functional>
#include <map>
#include <random>

using namespace lamella;
using dealii::Point;
using dealii::Tensor;
using dealii::numbers::PI;

BOOST_AUTO_TEST_SUITE(contact_surfaces)

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
            std::make_tuple(SectionShape(HalfDisc{0.5, 90., 0.1, 8, fabric}),
                            of_disc,
                            2e-4)})
        {
          const auto body = make_beam("body", shape, theory, 3., 2, placement);
          for (const std::string &surface : body->surfaces())
            {
              const dealii::QGauss<2> rule(4);
              double                  sum = 0., of_quadrature = 0.;
              for (const SurfaceFacet &facet : body->surface_facets(surface))
                {
                  for (unsigned int q = 0; q < rule.size(); ++q)
                    sum += rule.weight(q) *
                           body->surface_point(facet, rule.point(q)).area;
                  for (unsigned int k = 0; k < 4; ++k)
                    BOOST_TEST(
                      body->surface_point(facet, Point<2>(k % 2, k / 2))
                        .position.distance(facet.corners[k]) < 1e-14);
                }
              for (const SurfacePoint &p : body->surface_quadrature(surface))
                of_quadrature += p.area;
              BOOST_TEST(std::abs(sum / areas.at(surface) - 1.) < tolerance,
                         surface << ": " << sum);
              BOOST_TEST(std::abs(sum / of_quadrature - 1.) < 1e-6);
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
            SectionShape(HalfDisc{0.5, 75., 0.1, 4, fabric})})
        {
          const auto body = make_beam("body", shape, theory, 3., 2, placement);
          const MeshSurface   surface(*body, "all");
          const Vector        u = any_displacement(*body);
          std::vector<double> trace;
          for (const MeshSurface::Facet &facet : surface.facets())
            {
              const Point<2>     st(number(random), number(random));
              const SurfacePoint point = body->surface_point(facet.side, st);
              const auto         place = surface.map(facet, st);
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
          const Point<3> foot(0.3 + 0.29 * number(random),
                              1.5 + 1.49 * number(random),
                              0.2);
          Tensor<1, 3>   d(
            Point<3>(0.4 * number(random), 0.4 * number(random), -1.));
          d /= d.norm();
          const double t   = 0.1 * number(random);
          const auto   hit = top.meet(placement.to_scene(foot - t * d),
                                    placement.vector_to_scene(Point<3>(d)),
                                    0.2);
          BOOST_REQUIRE(hit.has_value());
          BOOST_TEST(std::abs(hit->distance - t) < 1e-13);
          BOOST_TEST(hit->position.distance(placement.to_scene(foot)) < 1e-13);
          BOOST_TEST((hit->normal - placement.axes[2]).norm() < 1e-13);
          // Out of reach, and along the normal instead of against it.
          BOOST_TEST(!top.meet(placement.to_scene(foot - t * d),
                               placement.vector_to_scene(Point<3>(d)),
                               0.9 * std::abs(t)));
          BOOST_TEST(!top.meet(placement.to_scene(foot - t * d),
                               placement.vector_to_scene(Point<3>(-d)),
                               0.2));
        }
      BOOST_TEST(
        !top.meet(placement.to_scene({0.61, 1., 0.3}), -placement.axes[2], 1.));

      // Onto the arc of a half disc about (0.5, 0). The mesh interpolates it:
      // off by 3e-7 and, in the normal, 2e-5 rad (LE-4).
      const auto        disc = make_beam("disc",
                                  HalfDisc{0.5, 90., 0.05, 8, fabric},
                                  layer_wise(4),
                                  1.,
                                  2,
                                  placement);
      const MeshSurface arc(*disc, "arc");
      for (unsigned int k = 0; k < 50; ++k)
        {
          const double   angle = 0.5 * PI * (1. + 0.8 * number(random));
          const Point<3> foot(0.5 + 0.5 * std::cos(angle),
                              0.5 + 0.49 * number(random),
                              0.5 * std::sin(angle));
          Tensor<1, 3>   n(Point<3>(std::cos(angle), 0., std::sin(angle)));
          Tensor<1, 3>   d = -n + 0.3 * Tensor<1, 3>(Point<3>(number(random),
                                                            number(random),
                                                            number(random)));
          d /= d.norm();
          const double t   = 0.2 * number(random);
          const auto   hit = arc.meet(placement.to_scene(foot - t * d),
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
                         placement.to_scene(foot - t * d) +
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
    const HalfDisc disc{8., 90., 0.2, 8, fabric};
    Bodies         bodies;
    bodies.push_back(make_beam("upper",
                               disc,
                               layer_wise(2),
                               1.,
                               1,
                               turned_over(placement, {16., 0., 16. + gap})));
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
            opposing_place(lower, point.position, point.normal, 16.);
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



BOOST_AUTO_TEST_CASE(mirrored_bodies_pair_all_nodes)
{
  // All but the two lines where the arcs end, whose normals are parallel.
  for (const Placement &placement : placements)
    {
      const Bodies bodies = two_half_discs(0.1, placement);
      auto contact        = pair_of("arc", "arc", Discretisation::node_to_node);
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
      for (const Discretisation discretisation :
           {Discretisation::node_to_node,
            Discretisation::node_to_surface,
            Discretisation::surface_to_surface})
        {
          if (!discs && discretisation == Discretisation::node_to_node)
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
          auto contact = discs ? pair_of("arc", "arc", discretisation) :
                                 pair_of("bottom", "top", discretisation);
          const ContactInterface one = make_interface(contact, bodies);
          std::swap(contact.first, contact.second);
          const ContactInterface two = make_interface(contact, bodies);

          // The lower strip has the finer grid; of equal ones the body that
          // comes first carries the points.
          if (discretisation != Discretisation::node_to_node)
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



BOOST_AUTO_TEST_CASE(polygons)
{
  const Polygon square{{0., 0.}, {2., 0.}, {2., 2.}, {0., 2.}};
  BOOST_TEST(area(square) == 4.);
  BOOST_TEST(area({{0., 0.}, {0., 2.}, {2., 2.}, {2., 0.}}) == -4.);
  // A diamond about (2, 1): a triangle of height 1 and base 2 is left.
  const Polygon diamond{{1., 1.}, {2., 0.}, {3., 1.}, {2., 2.}};
  BOOST_TEST(std::abs(area(clipped(square, diamond)) - 1.) < 1e-15);
  BOOST_TEST(std::abs(area(clipped(diamond, square)) - 1.) < 1e-15);
  BOOST_TEST(std::abs(area(clipped(square, square)) - 4.) < 1e-15);
  // Side by side.
  const Polygon beside{{2., 0.}, {4., 0.}, {4., 2.}, {2., 2.}};
  BOOST_TEST(std::abs(area(clipped(square, beside))) < 1e-15);
  BOOST_TEST(clipped(square, {{5., 5.}, {6., 5.}, {6., 6.}}).empty());
}



BOOST_AUTO_TEST_CASE(rules_on_triangles)
{
  // int x^i y^j = i! j! / (i + j + 2)!.
  for (unsigned int degree = 1; degree <= 20; ++degree)
    {
      const auto &rule = triangle_rule(degree);
      for (const double weight : rule.get_weights())
        BOOST_TEST(weight > 0.);
      for (unsigned int i = 0; i <= degree; ++i)
        {
          const unsigned int j   = degree - i;
          double             sum = 0.;
          for (unsigned int q = 0; q < rule.size(); ++q)
            sum += rule.weight(q) * std::pow(rule.point(q)[0], i) *
                   std::pow(rule.point(q)[1], j);
          const double due =
            std::tgamma(i + 1.) * std::tgamma(j + 1.) / std::tgamma(i + j + 3.);
          BOOST_TEST(std::abs(sum / due - 1.) < 1e-11,
                     degree << ", " << i << ": " << sum / due - 1.);
        }
    }
}



namespace
{
  /// Two strips: the upper one of @p across x @p along cells turned by
  /// @p degrees about z, its middle above the middle of the lower one, which
  /// is 2 wide and 3 long; 0.01 apart.
  Bodies
  crossed_strips(const Placement   &placement,
                 const double       degrees,
                 const double       width,
                 const double       length,
                 const unsigned int across,
                 const unsigned int along,
                 const Theory      &theory)
  {
    const double       angle = degrees * PI / 180.;
    const Tensor<1, 3> axis  = Point<3>(std::sin(angle), std::cos(angle), 0.),
                       x     = Point<3>(std::cos(angle), -std::sin(angle), 0.);
    const Point<3> corner =
      Point<3>(1., 1.5, 0.51) - 0.5 * width * x - 0.5 * length * axis;
    Bodies bodies;
    bodies.push_back(make_beam(
      "upper",
      rectangle(width, 0.4, {0.}, across),
      theory,
      length,
      along,
      Placement::from_directions(placement.to_scene(corner),
                                 placement.vector_to_scene(Point<3>(axis)),
                                 placement.axes[2])));
    bodies.push_back(make_beam(
      "lower", rectangle(2., 0.5, {0.}, 3), theory, 3., 2, placement));
    return bodies;
  }



  /// sum A_i n . (u_2 - u_1)_i, that is the integral over the overlap.
  double
  integral(const ContactInterface &interface, const BlockVector &u)
  {
    double sum = 0.;
    for (unsigned int k = 0; k < interface.rows.size(); ++k)
      sum += interface.points[k].area * interface.rows[k].opening(u);
    return sum;
  }
} // namespace



BOOST_AUTO_TEST_CASE(weighted_gaps_sum_to_the_integral)
{
  // The hat functions sum to one, so the rows times their areas sum to the
  // integral of n . (u_2 - u_1) over the overlap, here by a fine product rule:
  // strips of the same direction overlap in a rectangle, in which the columns
  // between all cell boundaries of both hold polynomials.
  for (const Placement &placement : placements)
    for (const Theory &theory : {layer_wise(2), layer_wise(3), taylor(2)})
      {
        const Bodies bodies =
          crossed_strips(placement, 0., 1.3, 2.1, 2, 3, theory);
        const auto interface = make_interface(
          pair_of("bottom", "top", Discretisation::surface_to_surface), bodies);
        double total = 0.;
        for (unsigned int k = 0; k < interface.rows.size(); ++k)
          {
            total += interface.points[k].area;
            BOOST_TEST(interface.points[k].area > 0.);
            BOOST_TEST(std::abs(interface.rows[k].initial_gap - 0.01) < 1e-13);
            BOOST_TEST((interface.points[k].normal + placement.axes[2]).norm() <
                       1e-13);
          }
        BOOST_TEST(std::abs(total - 1.3 * 2.1) < 1e-12);

        BlockVector u = zero(bodies);
        for (unsigned int b = 0; b < 2; ++b)
          u.block(b) = any_displacement(*bodies[b], b);
        const auto breaks = [](const double   low,
                               const double   high,
                               const unsigned n,
                               const double   low_2,
                               const double   high_2,
                               const unsigned n_2) {
          std::vector<double> all;
          for (unsigned int i = 0; i <= n; ++i)
            all.push_back(low + (high - low) * i / n);
          for (unsigned int i = 0; i <= n_2; ++i)
            if (const double x = low_2 + (high_2 - low_2) * i / n_2;
                x > low && x < high)
              all.push_back(x);
          std::sort(all.begin(), all.end());
          return all;
        };
        const auto xs = breaks(0.35, 1.65, 2, 0., 2., 3),
                   ys = breaks(0.45, 2.55, 3, 0., 3., 2);
        const dealii::QGauss<2> rule(5);
        double                  due = 0.;
        for (unsigned int i = 0; i + 1 < xs.size(); ++i)
          for (unsigned int j = 0; j + 1 < ys.size(); ++j)
            for (unsigned int q = 0; q < rule.size(); ++q)
              {
                const double x = xs[i] + rule.point(q)[0] * (xs[i + 1] - xs[i]),
                             y = ys[j] + rule.point(q)[1] * (ys[j + 1] - ys[j]);
                const auto at  = [&](const unsigned int b, const double z) {
                  return displacement(*bodies[b],
                                      bodies[b]->locate(
                                        {placement.to_scene({x, y, z})})[0][0],
                                      u.block(b));
                };
                due -= rule.weight(q) * (xs[i + 1] - xs[i]) *
                       (ys[j + 1] - ys[j]) * (at(1, 0.5) - at(0, 0.51)) *
                       placement.axes[2];
              }
        const double found = integral(interface, u);
        BOOST_TEST(std::abs(found - due) < 1e-11 * u.linfty_norm() * total,
                   found << " instead of " << due);
      }
}



BOOST_AUTO_TEST_CASE(overlaps_of_crossed_strips)
{
  // Strips of the widths b and 2 that cross at the angle alpha overlap in a
  // parallelogram of the area 2 b / sin(alpha).
  for (const Placement &placement : placements)
    for (const double degrees : {90., 45., 60.})
      {
        const double sine = std::sin(degrees * PI / 180.);
        for (const auto &[across, along] :
             {std::make_pair(1u, 2u), std::make_pair(4u, 9u)})
          {
            const Bodies bodies = crossed_strips(
              placement, degrees, 0.5, 6., across, along, layer_wise(2));
            const auto interface = make_interface(
              pair_of("bottom", "top", Discretisation::surface_to_surface),
              bodies);
            double total = 0.;
            for (const auto &point : interface.points)
              total += point.area;
            BOOST_TEST(std::abs(total / (1. / sine) - 1.) < 1e-12);

            // The resultant of any forces in the rows is lambda n on the
            // second, and both sides' are equal and opposite with their
            // moments: rows do no work on rigid motions of the whole.
            BlockVector  f = zero(bodies);
            Tensor<1, 3> force;
            for (unsigned int k = 0; k < interface.rows.size(); ++k)
              {
                const double lambda = 1. + std::sin(3. * k);
                interface.rows[k].add_to(f, lambda);
                force += lambda * interface.points[k].normal;
              }
            std::array<std::array<double, 6>, 2> on_body;
            for (unsigned int b = 0; b < 2; ++b)
              {
                const auto   motions = bodies[b]->rigid_motions();
                Tensor<1, 3> resultant, moment;
                for (unsigned int c = 0; c < 3; ++c)
                  {
                    resultant[c] = f.block(b) * motions[c];
                    moment[c]    = f.block(b) * motions[3 + c];
                  }
                // About the scene's origin.
                moment += cross_product_3d(bodies[b]->centre(), resultant);
                BOOST_TEST((resultant - (b == 1 ? 1. : -1.) * force).norm() <
                           1e-12 * force.norm());
                for (unsigned int c = 0; c < 3; ++c)
                  {
                    on_body[b][c]     = resultant[c];
                    on_body[b][3 + c] = moment[c];
                  }
              }
            for (unsigned int c = 0; c < 6; ++c)
              BOOST_TEST(std::abs(on_body[0][c] + on_body[1][c]) <
                         1e-11 * force.norm());
          }
      }
}



namespace
{
  /// The integral of @p f times the bilinear hat function of the grid's node at
  /// @p node.
  double
  hat_integral(
    const Body                                        &body,
    const std::string                                 &surface,
    const Point<3>                                    &node,
    const std::function<double(const SurfacePoint &)> &f =
      [](const SurfacePoint &) { return 1.; })
  {
    const dealii::QGauss<2> rule(6);
    double                  sum = 0.;
    for (const SurfaceFacet &facet : body.surface_facets(surface))
      {
        const GaussLobattoBasis s(facet.degree_s), t(facet.degree_t);
        for (unsigned int i = 0; i + 1 < s.size(); ++i)
          for (unsigned int j = 0; j + 1 < t.size(); ++j)
            for (unsigned int corner = 0; corner < 4; ++corner)
              {
                const bool right = corner % 2, up = corner / 2;
                if (body
                      .surface_point(facet,
                                     {s.point(i + right), t.point(j + up)})
                      .position.distance(node) > 1e-9)
                  continue;
                const double ds = s.point(i + 1) - s.point(i),
                             dt = t.point(j + 1) - t.point(j);
                for (unsigned int q = 0; q < rule.size(); ++q)
                  {
                    const double x = rule.point(q)[0], y = rule.point(q)[1];
                    const SurfacePoint point = body.surface_point(
                      facet, {s.point(i) + x * ds, t.point(j) + y * dt});
                    sum += rule.weight(q) * ds * dt * (right ? x : 1. - x) *
                           (up ? y : 1. - y) * point.area * f(point);
                  }
              }
      }
    return sum;
  }
} // namespace



BOOST_AUTO_TEST_CASE(each_row_is_an_average)
{
  // Row by row, on the side that carries them: -1/A_i int phi_i n . u_1 dA,
  // where all of the face lies above the other one.
  const Placement &placement = placements.back();
  for (const Theory &theory : {layer_wise(2), layer_wise(3), taylor(2)})
    {
      const Bodies bodies =
        crossed_strips(placement, 30., 0.8, 1., 2, 1, theory);
      ContactPair contact =
        pair_of("bottom", "top", Discretisation::surface_to_surface);
      contact.points_on     = PointsOn::first;
      const auto  interface = make_interface(contact, bodies);
      BlockVector u         = zero(bodies);
      u.block(0)            = any_displacement(*bodies[0]);
      for (unsigned int k = 0; k < interface.rows.size(); ++k)
        {
          const auto  &point = interface.points[k];
          const double area  = hat_integral(*bodies[0], "bottom", point.first);
          const double sum   = hat_integral(
            *bodies[0], "bottom", point.first, [&](const SurfacePoint &p) {
              return p.normal *
                     displacement(*bodies[0], p.location, u.block(0));
            });
          BOOST_TEST(std::abs(point.area / area - 1.) < 1e-11);
          BOOST_TEST(std::abs(interface.rows[k].opening(u) + sum / area) <
                     1e-11 * u.linfty_norm());
        }
    }
}



BOOST_AUTO_TEST_CASE(surfaces_behind_surfaces)
{
  // Under a strip lies a box, 1 wide and 0.5 high, whose cavity has a floor
  // that looks up, too: what is hidden does not pair. The strip, 0.4 wide, lies
  // along the box, 0.01 above it, over half of its wall and its cavity.
  for (const Discretisation discretisation :
       {Discretisation::node_to_surface, Discretisation::surface_to_surface})
    {
      Placement above;
      above.origin = Point<3>(0.05, 0., 0.51);
      Bodies bodies;
      bodies.push_back(make_beam(
        "strip", rectangle(0.4, 0.1, {0.}, 2), layer_wise(2), 2., 2, above));
      bodies.push_back(make_beam(
        "box",
        ThinWalled{"box", 1., 0.5, {0.1, 0.1}, {0.1, 0.1}, 1, 4, fabric},
        layer_wise(2),
        2.,
        3));
      ContactPair contact  = pair_of("bottom", "all", discretisation);
      contact.points_on    = PointsOn::first;
      const auto interface = make_interface(contact, bodies);
      double     area      = 0.;
      for (unsigned int k = 0; k < interface.rows.size(); ++k)
        {
          area += interface.points[k].area;
          BOOST_TEST(std::abs(interface.rows[k].initial_gap - 0.01) < 1e-13);
        }
      BOOST_TEST(std::abs(area - 0.8) < 1e-12);
    }
}



BOOST_AUTO_TEST_CASE(weighted_gaps_of_curved_bodies)
{
  // A half disc of radius 1 on a strip. Rigid motions of both bodies leave all
  // gaps as they are. The area of a row is the integral of its hat function
  // over the arc (wherever that faces the strip, so to 15 degrees off the
  // vertical in any case). The gap of a small cell is that of its node, from
  // the circle's point at the angle a along a / 2: (1.1 - cos a) / cos(a / 2).
  for (const Placement &placement : {placements.back()})
    {
      Bodies bodies;
      bodies.push_back(make_beam("disc",
                                 HalfDisc{1., 90., 0.05, 8, fabric},
                                 layer_wise(4),
                                 1.,
                                 1,
                                 turned_over(placement, {2., 0.5, 1.6})));
      bodies.push_back(make_beam(
        "strip", rectangle(2., 0.5, {0.}, 5), layer_wise(2), 2., 3, placement));
      const auto interface = make_interface(
        pair_of("arc", "top", Discretisation::surface_to_surface), bodies);
      BlockVector u = zero(bodies);
      for (unsigned int b = 0; b < 2; ++b)
        {
          const auto         motions = bodies[b]->rigid_motions();
          const Tensor<1, 3> w       = Point<3>(0.3, -0.2, 0.5);
          const Tensor<1, 3> v       = Tensor<1, 3>(Point<3>(0.1, 0.7, -0.4)) +
                                 cross_product_3d(w, bodies[b]->centre());
          for (unsigned int c = 0; c < 3; ++c)
            {
              u.block(b).add(v[c], motions[c]);
              u.block(b).add(w[c], motions[3 + c]);
            }
        }
      for (unsigned int k = 0; k < interface.rows.size(); ++k)
        {
          // A rotation moves X_2 against X_1 along w x (X_2 - X_1): none along
          // n, which is the direction between them.
          BOOST_TEST(std::abs(interface.rows[k].opening(u)) < 1e-11);
          const Point<3> x   = placement.to_body(interface.points[k].first);
          const double   a   = std::asin(std::clamp(x[0] - 1., -1., 1.));
          const double   due = (0.1 + 1. - std::cos(a)) / std::cos(0.5 * a);
          if (std::abs(a) < 0.05)
            BOOST_TEST(std::abs(interface.rows[k].initial_gap - due) < 2e-4);
          if (std::abs(a) < 15. / 180. * PI && k % 17 == 0)
            BOOST_TEST(
              std::abs(
                interface.points[k].area /
                  hat_integral(*bodies[0], "arc", interface.points[k].first) -
                1.) < 1e-8);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
