// SPDX-License-Identifier: LGPL-2.1-or-later

// Plies that follow walls: their axes, the feet of points on an ellipse, tubes
// against closed forms, walls against the same laminate turned, and that
// every theory and solids have the same law at the same point.

#include "patch_states.h"
#include "solid_fixtures.h"

#include <lamella/body/solid.h>
#include <lamella/section/saint_venant.h>
#include <lamella/shape/curve_normals.h>
#include <lamella/shape/properties.h>
#include <lamella/shape/shapes.h>

#include <deal.II/lac/full_matrix.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

BOOST_AUTO_TEST_SUITE(wall_plies)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;
using dealii::numbers::PI;

namespace
{
  const EngineeringConstants isotropic =
    EngineeringConstants::isotropic(210., 0.3);
  const Materials carbon{{"material", orthotropic}};



  void
  check_near(const double found, const double wanted, const double tolerance)
  {
    BOOST_TEST(std::abs(found / wanted - 1.) < tolerance,
               found << " and not " << wanted);
  }



  /// Plies of equal shares of @p thickness at @p angles.
  WallLayup
  layup(const std::vector<double> &angles, const double thickness)
  {
    WallLayup plies;
    for (const double angle : angles)
      plies.push_back({{"material", angle}, thickness / angles.size()});
    return plies;
  }



  Tube
  tube(const double               width,
       const double               height,
       const double               thickness,
       const std::vector<double> &angles       = {0.},
       const unsigned int         cells_around = 16)
  {
    return {width, height, layup(angles, thickness), cells_around, 1};
  }



  std::shared_ptr<const Section>
  section_of(const SectionShape &shape,
             const Material     &material = isotropic,
             const unsigned int  degree   = 3)
  {
    return make_section(make_section_mesh(shape, {{"material", material}}),
                        degree);
  }



  /// About the center of the section, forces and moments of SaintVenant::Force.
  SectionTensor
  stiffness_of(const Section &section)
  {
    return SaintVenant(section).stiffness();
  }



  SectionConstants
  constants_of(const Section &section)
  {
    return section_constants(SaintVenant(section).compliance(),
                             section.element().center());
  }
} // namespace

BOOST_AUTO_TEST_CASE(axes_of_a_ply)
{
  // Level: those of a laminate. Elsewhere e_1 = sin t + cos y, t = y x n.
  for (const double angle : {0., 30., -45., 90.})
    {
      const Triad level = ply_axes(angle, Point<2>(0., 1.));
      BOOST_TEST((level - ply_axes(angle)).norm() == 0.);
      for (const double phi : {0., 0.3, 2.1, -1.2})
        {
          const Point<2>     in_section(std::cos(phi), std::sin(phi));
          const Triad        axes = ply_axes(angle, in_section);
          const Tensor<1, 3> n({in_section[0], 0., in_section[1]}),
            y({0., 1., 0.}), t = cross_product_3d(y, n),
                             e_1 = std::sin(angle * PI / 180.) * t +
                                   std::cos(angle * PI / 180.) * y;
          BOOST_TEST((axes[0] - e_1).norm() < 1e-15);
          BOOST_TEST((axes[2] - n).norm() < 1e-15);
          BOOST_TEST((axes[1] - cross_product_3d(n, e_1)).norm() < 1e-15);
        }
    }
}



BOOST_AUTO_TEST_CASE(expansion_turns_with_the_wall)
{
  // Fibers all round: alpha_1 along the wall, alpha_2 along the beam, alpha_3
  // through the wall, wherever that is.
  Ply ply;
  ply.angle                           = 90.;
  ply.properties.expansion            = Tensor<1, 3>({1e-6, 3e-5, 5e-5});
  ply.plane.normal                    = Point<2>(1., 0.);
  const Voigt                 upright = ply.expansion(Point<2>());
  const std::array<double, 6> wanted{{5e-5, 3e-5, 1e-6, 0., 0., 0.}};
  for (unsigned int c = 0; c < 6; ++c)
    BOOST_TEST(std::abs(upright[c] - wanted[c]) < 1e-20);

  ply.plane.normal_at = [](const Point<2> &x) { return x / x.norm(); };
  for (const double phi : {0., 0.3, 2.1, -1.2})
    {
      const double c = std::cos(phi), s = std::sin(phi);
      const Voigt  alpha = ply.expansion(Point<2>(2. * c, 2. * s));
      // epsilon_nn = c^2 e_xx + s^2 e_zz + c s gamma_xz, and so on.
      BOOST_TEST(std::abs(c * c * alpha[0] + s * s * alpha[2] +
                          c * s * alpha[4] - 5e-5) < 1e-19);
      BOOST_TEST(std::abs(s * s * alpha[0] + c * c * alpha[2] -
                          c * s * alpha[4] - 1e-6) < 1e-19);
      BOOST_TEST(std::abs(alpha[1] - 3e-5) < 1e-19);
    }
}



BOOST_AUTO_TEST_CASE(feet_on_an_ellipse)
{
  // A point at the depth d below E(phi) has its foot there.
  for (const auto &[a, b] : {std::make_pair(3., 1.), {1., 2.5}, {2., 2.}})
    {
      const EllipseProjection ellipse(Point<2>(0.4, -0.7), a, b);
      const double deepest = std::pow(std::min(a, b), 2) / std::max(a, b);
      for (int k = -11; k <= 12; ++k)
        for (const double depth : {-0.2, 0., 0.4, 0.9})
          {
            const double   phi = k * PI / 12.;
            const Point<2> x =
              ellipse.point(phi) - depth * deepest * ellipse.normal(phi);
            const double found = ellipse.parameter(x);
            BOOST_TEST((ellipse.point(found) - ellipse.point(phi)).norm() <
                       1e-12);
            BOOST_TEST((ellipse.normal(found) - ellipse.normal(phi)).norm() <
                       1e-12);
          }
    }
}



BOOST_AUTO_TEST_CASE(circular_tube)
{
  // E pi (R^4 - r^4) / 4, G pi (R^4 - r^4) / 2.
  const double R = 0.5, r = 0.4, fourth = std::pow(R, 4) - std::pow(r, 4);
  const auto   bar = constants_of(*section_of(tube(2. * R, 2. * R, R - r)));
  check_near(bar.EA, 210. * PI * (R * R - r * r), 1e-6);
  check_near(bar.EI[0], 210. * PI * fourth / 4., 1e-6);
  check_near(bar.EI[1], 210. * PI * fourth / 4., 1e-6);
  check_near(bar.GJ, 210. / 2.6 * PI * fourth / 2., 1e-6);
  BOOST_TEST(bar.shear_center.distance(Point<2>(R, R)) < 1e-8);
  BOOST_TEST(bar.tension_center.distance(Point<2>(R, R)) < 1e-8);
}



BOOST_AUTO_TEST_CASE(elliptical_tube)
{
  // As thick all round: area L t - pi t^2, L the length of the ellipse outside.
  // Second moments from its strips, E(phi) - s n(phi) for s from 0 to t, by the
  // trapezoidal rule, which is exact to rounding for periodic functions. Bredt:
  // G 4 A_m^2 t / L_m of the middle line.
  const double a = 1., b = 0.6, t = 0.02;
  const auto   section = section_of(tube(2. * a, 2. * b, t, {0.}, 32));
  const auto   bar     = constants_of(*section);
  const double L       = 4. * a * std::comp_ellint_2(std::sqrt(1. - b * b));
  check_near(bar.EA / 210., L * t - PI * t * t, 1e-6);

  const EllipseProjection ellipse(Point<2>(), a, b);
  const unsigned int      n = 400;
  const dealii::QGauss<1> through(4);
  Tensor<1, 2>            moments;
  double                  enclosed = 0.;
  for (unsigned int k = 0; k < n; ++k)
    {
      const double phi   = 2. * PI * k / n;
      const double speed = std::hypot(a * std::sin(phi), b * std::cos(phi)),
                   kappa = a * b / std::pow(speed, 3);
      for (unsigned int q = 0; q < through.size(); ++q)
        {
          const double       s = t * through.point(q)[0];
          const Tensor<1, 2> x = ellipse.point(phi) - s * ellipse.normal(phi);
          for (unsigned int d = 0; d < 2; ++d)
            moments[d] += 2. * PI / n * t * through.weight(q) * speed *
                          (1. - s * kappa) * x[d] * x[d];
        }
      const Tensor<1, 2> middle =
        ellipse.point(phi) - 0.5 * t * ellipse.normal(phi);
      enclosed += PI / n * speed * (1. - 0.5 * t * kappa) *
                  (middle * ellipse.normal(phi));
    }
  check_near(bar.EI[0], 210. * moments[0], 1e-6);
  check_near(bar.EI[1], 210. * moments[1], 1e-6);
  check_near(bar.GJ,
             210. / 2.6 * 4. * enclosed * enclosed * t / (L - PI * t),
             1e-3);
}



BOOST_AUTO_TEST_CASE(wound_tube)
{
  // A thin tube under tension and torsion is a membrane, without hoop stress:
  // with the compliance S of the ply in (y, t), N = (sigma_y, tau) t holds
  // (eps, gamma) by the inverse of [S_yy, S_yt; S_yt, S_tt]. gamma = R kappa_y.
  // A force F_y on a ply at +30 degrees lets it shear as the sign of S_yt says.
  // Off by the square of the thickness over the radius and by what the layup
  // bends of itself, which one ply does not.
  const double R = 1., t = 0.01, angle = 30.;
  const auto   section =
    section_of(tube(2. * R + t, 2. * R + t, t, {angle}), orthotropic);
  const SectionTensor found = stiffness_of(*section);

  // Plane stress about the fiber: strains of sigma_y = 1 and tau = 1.
  const EngineeringConstants &m = orthotropic;
  const double c = std::cos(angle * PI / 180.), s = std::sin(angle * PI / 180.);
  const double S11 = 1. / m.E1, S22 = 1. / m.E2, S12 = -m.nu12 / m.E1,
               S66  = 1. / m.G12;
  const double S_yy = S11 * std::pow(c, 4) + S22 * std::pow(s, 4) +
                      (2. * S12 + S66) * s * s * c * c;
  const double S_yt = (2. * S11 - 2. * S12 - S66) * s * std::pow(c, 3) -
                      (2. * S22 - 2. * S12 - S66) * std::pow(s, 3) * c;
  const double S_tt =
    2. * (2. * S11 + 2. * S22 - 4. * S12 - S66) * s * s * c * c +
    S66 * (std::pow(s, 4) + std::pow(c, 4));
  const double determinant = S_yy * S_tt - S_yt * S_yt;
  const double ring        = 2. * PI * R * t;
  // t goes from the top towards +x, as the rotation about y takes it: u = kappa
  // y (z, 0, -x), which is along t all round.
  check_near(found[1][1], ring * S_tt / determinant, 3e-4);
  check_near(found[1][4], -R * ring * S_yt / determinant, 3e-4);
  check_near(found[4][4], R * R * ring * S_yy / determinant, 3e-4);
  // The same all round: no direction of bending is another's better.
  const auto bar = constants_of(*section);
  check_near(bar.EI[0], bar.EI[1], 1e-6);
}



BOOST_AUTO_TEST_CASE(turn_of_a_wall)
{
  // A wall whose normal is turned from +z to +x is the laminate with x in the
  // place of z and -z in that of x: forces and moments change places so.
  const std::vector<double> angles{30., -10., 75.};
  const double              width = 3., height = 1.;
  const Laminate            laminate = rectangle(width, height, angles, 3, 1);
  const auto                level    = make_section_mesh(laminate, carbon);
  auto                      upright  = std::make_shared<SectionMesh>();
  upright->mesh.copy_triangulation(level->mesh);
  // (x, z) -> (z, width - x).
  dealii::GridTools::transform(
    [width](const Point<2> &p) { return Point<2>(p[1], width - p[0]); },
    upright->mesh);
  upright->plies      = level->plies;
  upright->boundaries = level->boundaries;
  for (Ply &ply : upright->plies)
    ply.plane.normal = Point<2>(1., 0.);
  const SectionTensor a = stiffness_of(*make_section(level, 3)),
                      b = stiffness_of(*make_section(upright, 3));
  // New x is old z, new z is minus old x.
  constexpr std::array<unsigned int, 6> of{{2, 1, 0, 5, 4, 3}};
  constexpr std::array<double, 6>       sign{{1., 1., -1., 1., 1., -1.}};
  for (unsigned int i = 0; i < 6; ++i)
    for (unsigned int j = 0; j < 6; ++j)
      BOOST_TEST(std::abs(b[i][j] - sign[i] * sign[j] * a[of[i]][of[j]]) <
                 1e-8 * std::sqrt(a[of[i]][of[i]] * a[of[j]][of[j]]));
}



BOOST_AUTO_TEST_CASE(box_of_one_helix)
{
  // Of one layup all round a square box is the same after a quarter turn, but
  // for its corners, whose plies are the flanges': a thin one. Its twist under
  // tension has the sign of a tube's.
  const double        t = 0.02;
  const ThinWalled    box{ShapeKind::box,
                       1.,
                       1.,
                       {t, t},
                       {t, t},
                       1,
                       6,
                       {},
                       std::vector<WallLayup>(4, layup({30.}, t)),
                       2};
  const SectionTensor found = stiffness_of(*section_of(box, orthotropic, 2));
  const SectionTensor round =
    stiffness_of(*section_of(tube(1., 1., t, {30.}), orthotropic, 2));
  check_near(found[3][3], found[5][5], 0.02);
  BOOST_TEST(found[1][4] * round[1][4] > 0.);
  // Walls that are mirrored do not twist under tension.
  ThinWalled mirrored = box;
  for (const unsigned int w : {0, 2})
    mirrored.layups[w] = layup({-30.}, t);
  const SectionTensor other =
    stiffness_of(*section_of(mirrored, orthotropic, 2));
  BOOST_TEST(std::abs(other[1][4]) < 0.02 * std::abs(found[1][4]));
}



BOOST_AUTO_TEST_CASE(plies_of_walls)
{
  // Of a channel: webs first, from the inside to the outside, which is to the
  // left; the corners are the flanges'.
  const ThinWalled          channel{ShapeKind::channel,
                           1.,
                           2.,
                           {0.2},
                           {0.1, 0.3},
                           1,
                           2,
                           {},
                           {layup({10., 20.}, 0.2),
                                     layup({30.}, 0.1),
                                     layup({40., 50., 60.}, 0.3)},
                           1};
  const auto                mesh = make_section_mesh(channel, carbon);
  const auto                p    = section_properties(*mesh);
  const double              web = 0.1 * 1.6, bottom = 0.1, top = 0.1;
  const std::vector<double> angles{10., 20., 30., 40., 50., 60.},
    areas{web, web, bottom, top, top, top}, normal_x{-1., -1., 0., 0., 0., 0.},
    normal_z{0., 0., -1., 1., 1., 1.};
  BOOST_TEST_REQUIRE(mesh->plies.size() == 6);
  for (unsigned int i = 0; i < 6; ++i)
    {
      BOOST_TEST(mesh->plies[i].angle == angles[i]);
      BOOST_TEST(std::abs(p.ply_areas[i] - areas[i]) < 1e-12);
      BOOST_TEST(mesh->plies[i].plane.normal[0] == normal_x[i]);
      BOOST_TEST(mesh->plies[i].plane.normal[1] == normal_z[i]);
    }
  for (const auto &cell : mesh->mesh.active_cell_iterators())
    {
      const Point<2> c = cell->center();
      if (cell->material_id() == 0)
        BOOST_TEST((c[0] > 0.1 && c[1] > 0.1 && c[1] < 1.7));
      if (cell->material_id() == 3)
        BOOST_TEST((c[1] > 1.7 && c[1] < 1.8));
    }
  BOOST_TEST(mesh->plies[5].bottom == 1.9, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(mesh->plies[5].top == 2., boost::test_tools::tolerance(1e-12));
}



namespace
{
  /// int e_a^T C e_b dA of @p section for all fields a and b by @p n Gauss
  /// points a direction and cell, for the strains that values multiply, C from
  /// Ply alone.
  dealii::FullMatrix<double>
  energies_of(const Section &section, const unsigned int n)
  {
    const dealii::QGauss<2>    gauss(n);
    dealii::FullMatrix<double> sum(section.n_fields(), section.n_fields());
    for (unsigned int cell = 0; cell < section.n_cells(); ++cell)
      for (unsigned int q = 0; q < gauss.size(); ++q)
        {
          const SectionPoint  point = section.evaluate(cell, gauss.point(q));
          const Ply          &ply   = section.plies()[section.cell_ply(cell)];
          const ElasticTensor C = rotated(ply.properties.elastic.stiffness(),
                                          ply.axes(point.position));
          const double        weight = gauss.weight(q) * point.jacobian;
          for (unsigned int b = 0; b < section.n_fields(); ++b)
            {
              const Voigt stress = weight * (C * point.in_plane[b]);
              for (unsigned int a = 0; a < section.n_fields(); ++a)
                sum(a, b) += point.in_plane[a] * stress;
            }
        }
    return sum;
  }
} // namespace



BOOST_AUTO_TEST_CASE(matrices_of_curved_plies)
{
  // By moments of harmonics (TE-4) and point by point (TE-1 without its
  // contraction, whose fields come first in the same order) against quadrature
  // of more points.
  const SectionShape shape = tube(2., 1.4, 0.1, {30., -60.}, 24);
  const auto         mesh  = make_section_mesh(shape, carbon);
  for (const unsigned int order : {1, 4})
    {
      Theory theory;
      theory.kind               = Theory::Kind::TE;
      theory.order              = order;
      theory.poisson_correction = false;
      const auto section        = make_section(mesh, theory);
      const auto wanted         = energies_of(*section, 8);
      for (unsigned int a = 3; a < section->n_fields(); a += 2)
        for (unsigned int b = 3; b < section->n_fields(); b += 3)
          BOOST_TEST(std::abs(section->S(0, 0).el(a, b) - wanted(a, b)) <=
                     1e-6 * std::sqrt(wanted(a, a) * wanted(b, b)));
    }
}



namespace
{
  /// Any displacement, the same each time.
  Vector
  some_displacement(const Body &body)
  {
    Vector u(body.n_dofs());
    for (unsigned int i = 0; i < u.size(); ++i)
      u[i] = std::sin(1. + 0.7 * i);
    return u;
  }
} // namespace



BOOST_AUTO_TEST_CASE(stresses_of_bodies)
{
  // Of any displacement, at any point of a tube: the stress is that of the
  // strain by the law whose axes are turned there, in ply axes that of the
  // material's own; rows say the same; forces work as much as energy says.
  const auto mesh =
    make_section_mesh(SectionShape(tube(2., 2., 0.2, {40.})), carbon);
  const AxisMesh      axis = axis_mesh(1., 2);
  const Beam          beam("beam",
                  make_section(mesh, 2),
                  std::make_shared<Axis>(axis),
                  tilted);
  const Solid         solid("solid", mesh, axis, tilted, 2);
  const ElasticTensor own = orthotropic.stiffness();
  for (const Body *body :
       {static_cast<const Body *>(&beam), static_cast<const Body *>(&solid)})
    {
      const Vector u = some_displacement(*body);
      for (const double phi : {0.1, 1.9, 4.})
        {
          const Point<2> n(std::cos(phi), std::sin(phi));
          const Point<3> x(1. + 0.9 * n[0], 0.4, 1. + 0.9 * n[1]);
          const Location where = body->locate({tilted.to_scene(x)}).at(0).at(0);
          const FieldSample found  = body->sample(where, u);
          const Triad       axes   = ply_axes(40., n) * tilted.axes;
          const Voigt       in_ply = strain_rotation(axes) * found.strain;
          // The mesh interpolates the circle: the foot is a little beside.
          BOOST_TEST((found.stress - rotated(own, axes) * found.strain).norm() <
                     1e-4 * found.stress.norm());
          BOOST_TEST((found.ply_stress - own * in_ply).norm() <
                     1e-4 * found.stress.norm());
          check_rows_are_fields(*body, where, u);
        }
      Vector f(body->n_dofs());
      body->add_internal_forces(u, f);
      check_near(0.5 * (u * f), body->deformation(u).energy, 1e-9);
    }
}



BOOST_AUTO_TEST_CASE(energy_of_a_solid)
{
  // Under a uniform strain: 1/2 L int eps C eps dA, C all round by quadrature.
  const double R = 1., r = 0.8, L = 1.3, angle = 40.;
  const auto   mesh =
    make_section_mesh(SectionShape(tube(2. * R, 2. * R, R - r, {angle}, 24)),
                      carbon);
  for (unsigned int place = 0; place < 6; ++place)
    {
      const Solid solid("solid", mesh, axis_mesh(L, 1), Placement(), 2);
      Vector      u(solid.n_dofs());
      const auto &nodes = solid.hexahedra().nodes();
      const auto  E     = unit_strain(place);
      for (unsigned int i = 0; i < nodes.size(); ++i)
        for (unsigned int c = 0; c < 3; ++c)
          u[3 * i + c] = (E * Tensor<1, 3>(nodes[i]))[c];
      Voigt strain;
      strain[place]        = 1.;
      double             e = 0.;
      const unsigned int n = 100;
      for (unsigned int k = 0; k < n; ++k)
        {
          const double        phi = 2. * PI * k / n;
          const ElasticTensor C =
            rotated(orthotropic.stiffness(),
                    ply_axes(angle, Point<2>(std::cos(phi), std::sin(phi))));
          e += 0.5 * L * PI * (R * R - r * r) / n * (strain * (C * strain));
        }
      check_near(solid.deformation(u).energy, e, 1e-5);
    }
}



BOOST_AUTO_TEST_CASE(normals_of_a_curve)
{
  // Of a polygon on a circle the polar direction; of one on an ellipse the
  // normal of the foot, to the second order of a side's length.
  std::vector<double> worst;
  for (const unsigned int n : {32, 64})
    for (const double b : {1., 0.7})
      {
        const auto mesh =
          make_section_mesh(SectionShape(tube(2., 2. * b, 0.2, {0.}, n)),
                            carbon);
        const EllipseProjection ellipse(Point<2>(1., b), 1., b);
        const CurveNormals outer(*mesh, {"outer"}), inner(*mesh, {"inner"});
        worst.push_back(0.);
        for (double phi = 0.01; phi < 6.28; phi += 0.1)
          {
            const Tensor<1, 2> normal = ellipse.normal(phi);
            const Point<2>     x      = ellipse.point(phi) - 0.1 * normal;
            worst.back()              = std::max({worst.back(),
                                                  (outer.at(x) - normal).norm(),
                                                  (inner.at(x) + normal).norm()});
          }
      }
  BOOST_TEST(worst[0] < 1e-12);
  BOOST_TEST(worst[2] < 1e-12);
  BOOST_TEST(worst[3] < 0.3 * worst[1]);
  BOOST_TEST(worst[1] < 0.02);
}



BOOST_AUTO_TEST_CASE(normals_at_corners)
{
  // Around a box each point has the normal of the nearest wall.
  const ThinWalled box{
    ShapeKind::box, 2., 1., {0.1, 0.1}, {0.1, 0.1}, 1, 3, {"material", 0.}};
  const auto         mesh = make_section_mesh(SectionShape(box), carbon);
  const CurveNormals outside(*mesh, {"left", "right", "bottom", "top"});
  const std::vector<std::pair<Point<2>, Point<2>>> wanted{
    {{0.05, 0.5}, {-1., 0.}},
    {{0.05, 0.9}, {-1., 0.}},
    {{1.97, 0.1}, {1., 0.}},
    {{1.9, 0.03}, {0., -1.}},
    {{0.06, 0.97}, {0., 1.}}};
  for (const auto &[x, normal] : wanted)
    BOOST_TEST((outside.at(x) - normal).norm() < 1e-14);
}

BOOST_AUTO_TEST_SUITE_END()
