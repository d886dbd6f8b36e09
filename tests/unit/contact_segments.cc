// SPDX-License-Identifier: LGPL-2.1-or-later

// Segments and weighted gaps: what two surfaces have in common, cut, integrated
// and averaged. Geometry alone, nothing is solved; see contact_patch.cc for
// what comes of it.

#include "contact_fixtures.h"

#include <lamella/body/surface_topology.h>
#include <lamella/contact/pairing.h>
#include <lamella/contact/segments.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

BOOST_AUTO_TEST_SUITE(contact_segments)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;
using dealii::numbers::PI;

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
      sum += interface.points[k].area * interface.rows[k].jump(u);
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
          pair_of("bottom", "top", Discretization::surface_to_surface), bodies);
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
              pair_of("bottom", "top", Discretization::surface_to_surface),
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
                const auto   motions = bodies[b]->rigid_motions(undisplaced);
                Tensor<1, 3> resultant, moment;
                for (unsigned int c = 0; c < 3; ++c)
                  {
                    resultant[c] = f.block(b) * motions[c];
                    moment[c]    = f.block(b) * motions[3 + c];
                  }
                // About the scene's origin.
                moment += cross_product_3d(bodies[b]->center(), resultant);
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
    for (const SurfaceFacet &facet : surface_facets(body, surface))
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
        pair_of("bottom", "top", Discretization::surface_to_surface);
      contact.slave_side    = SlaveSide::first;
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
          BOOST_TEST(std::abs(interface.rows[k].jump(u) + sum / area) <
                     1e-11 * u.linfty_norm());
        }
    }
}



BOOST_AUTO_TEST_CASE(surfaces_behind_surfaces)
{
  // Under a strip lies a box, 1 wide and 0.5 high, whose cavity has a floor
  // that looks up, too: what is hidden does not pair. The strip, 0.4 wide, lies
  // along the box, 0.01 above it, over half of its wall and its cavity.
  for (const Discretization discretization :
       {Discretization::node_to_surface, Discretization::surface_to_surface})
    {
      Placement above;
      above.origin = Point<3>(0.05, 0., 0.51);
      Bodies bodies;
      bodies.push_back(make_beam(
        "strip", rectangle(0.4, 0.1, {0.}, 2), layer_wise(2), 2., 2, above));
      bodies.push_back(make_beam("box",
                                 ThinWalled{ShapeKind::box,
                                            1.,
                                            0.5,
                                            {0.1, 0.1},
                                            {0.1, 0.1},
                                            1,
                                            4,
                                            oriented_material},
                                 layer_wise(2),
                                 2.,
                                 3));
      ContactPair contact  = pair_of("bottom", "all", discretization);
      contact.slave_side   = SlaveSide::first;
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
                                 HalfDisc{1., 90., 0.05, 8, oriented_material},
                                 layer_wise(4),
                                 1.,
                                 1,
                                 upside_down(placement, {2., 0.5, 1.6})));
      bodies.push_back(make_beam(
        "strip", rectangle(2., 0.5, {0.}, 5), layer_wise(2), 2., 3, placement));
      const auto interface = make_interface(
        pair_of("arc", "top", Discretization::surface_to_surface), bodies);
      BlockVector u = zero(bodies);
      for (unsigned int b = 0; b < 2; ++b)
        {
          const auto         motions = bodies[b]->rigid_motions(undisplaced);
          const Tensor<1, 3> w       = Point<3>(0.3, -0.2, 0.5);
          const Tensor<1, 3> v       = Tensor<1, 3>(Point<3>(0.1, 0.7, -0.4)) +
                                 cross_product_3d(w, bodies[b]->center());
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
          BOOST_TEST(std::abs(interface.rows[k].jump(u)) < 1e-11);
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
