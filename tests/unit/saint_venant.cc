// SPDX-License-Identifier: LGPL-2.1-or-later

// The six Saint-Venant states of a section against closed forms: Saint-Venant's
// own solutions for a square and an ellipse, thin walls, the rotated compliance
// of an off-axis bar, lamination theory.

#include "fixtures.h"

#include <lamella/section/saint_venant.h>
#include <lamella/shape/properties.h>
#include <lamella/shape/shapes.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(saint_venant)

using namespace lamella;
using dealii::Point;
using dealii::numbers::PI;
using Force = SaintVenant::Force;

namespace
{
  const EngineeringConstants isotropic =
    EngineeringConstants::isotropic(210., 0.3);
  const EngineeringConstants
    orthotropic{165., 9., 8., 5.6, 5.2, 2.8, 0.34, 0.3, 0.45};
  const OrientedMaterial oriented_material{"material", 0.};

  std::shared_ptr<const Section>
  section_of(const SectionShape         &shape,
             const EngineeringConstants &material = isotropic,
             const unsigned int          degree   = 3)
  {
    return make_section(make_section_mesh(shape, {{"material", material}}),
                        degree);
  }



  SectionConstants
  constants_of(const Section &section)
  {
    return section_constants(SaintVenant(section).compliance(),
                             section.element().center());
  }



  void
  check_near(const double found, const double wanted, const double tolerance)
  {
    BOOST_TEST(std::abs(found / wanted - 1.) < tolerance,
               found << " and not " << wanted);
  }
} // namespace

BOOST_AUTO_TEST_CASE(square)
{
  // E b^2, E b^4 / 12; G b^4 0.1405770 (Timoshenko and Goodier, series); k of
  // shear is 5/6 for nu = 0.
  const double b = 0.4;
  const auto   bar =
    constants_of(*section_of(rectangle(b, b, {0.}, 4, 4), isotropic));
  const double G = 210. / 2.6;
  check_near(bar.EA, 210. * b * b, 1e-9);
  check_near(bar.EI[0], 210. * std::pow(b, 4) / 12., 1e-9);
  check_near(bar.EI[1], 210. * std::pow(b, 4) / 12., 1e-9);
  check_near(bar.GJ, 0.1405770 * G * std::pow(b, 4), 1e-4);
  const Point<2> middle(0.5 * b, 0.5 * b);
  BOOST_TEST(bar.tension_center.distance(middle) < 1e-10 * b);
  BOOST_TEST(bar.shear_center.distance(middle) < 1e-10 * b);

  const auto without =
    constants_of(*section_of(rectangle(b, b, {0.}, 4, 4),
                             EngineeringConstants::isotropic(210., 0.)));
  check_near(without.kGA_x, 5. / 6. * 105. * b * b, 1e-9);
  check_near(without.kGA_z, 5. / 6. * 105. * b * b, 1e-9);
}



BOOST_AUTO_TEST_CASE(ellipse)
{
  // G pi a^3 c^3 / (a^2 + c^2), E pi a c^3 / 4 with half axes a along x, c
  // along z. The larger bending stiffness is that about z, at 90 degrees.
  const double a = 0.5, c = 0.3;
  const auto   bar =
    constants_of(*section_of(Ellipse{2. * a, 2. * c, 0, oriented_material}));
  const double G = 210. / 2.6;
  check_near(bar.EA, 210. * PI * a * c, 1e-4);
  check_near(bar.EI[0], 210. * PI * c * a * a * a / 4., 2e-4);
  check_near(bar.EI[1], 210. * PI * a * c * c * c / 4., 2e-4);
  check_near(std::abs(bar.angle), 90., 1e-6);
  check_near(bar.GJ, G * PI * std::pow(a * c, 3) / (a * a + c * c), 1e-3);
}



BOOST_AUTO_TEST_CASE(channel)
{
  // The shear center of a thin channel lies outside, behind the web: by 3 b^2 /
  // (h + 6 b) from its middle line, b and h those of the middle lines (Gere and
  // Timoshenko); 1 / 3 sum of length times thickness^3 is its J.
  const double t = 0.02, width = 0.5, height = 1.;
  const auto   bar = constants_of(*section_of(ThinWalled{
    ShapeKind::channel, width, height, {t}, {t, t}, 1, 6, oriented_material}));
  const double b = width - 0.5 * t, h = height - t;
  const double e = 3. * b * b / (h + 6. * b);
  BOOST_TEST(std::abs(bar.shear_center[0] - (0.5 * t - e)) < 0.01 * e);
  BOOST_TEST(std::abs(bar.shear_center[1] - 0.5 * height) < 1e-6 * height);
  check_near(bar.GJ, 210. / 2.6 * (h + 2. * b) * t * t * t / 3., 0.03);
  const auto geometry = section_properties(*make_section_mesh(
    ThinWalled{
      ShapeKind::channel, width, height, {t}, {t, t}, 1, 6, oriented_material},
    {{"material", isotropic}}));
  BOOST_TEST(bar.tension_center.distance(geometry.centroid) < 1e-8);
  check_near(bar.EI[0], 210. * geometry.second_moments[1][1], 1e-8);
}



BOOST_AUTO_TEST_CASE(off_axis)
{
  // Far from its ends a homogeneous bar is under s_yy alone when pulled or
  // bent: compliances 1 / (A E_y), 1 / (I E_y) with 1 / E_y of the rotated
  // compliance, whatever it shears.
  const double b = 0.6, h = 0.2, angle = 30.;
  const auto   section =
    section_of(rectangle(b, h, {angle}, 4, 2), orthotropic, 3);
  const SaintVenant          states(*section);
  dealii::FullMatrix<double> S(6);
  const ElasticTensor        C = section->plies()[0].stiffness();
  for (unsigned int i = 0; i < 6; ++i)
    for (unsigned int j = 0; j < 6; ++j)
      S(i, j) = C[i][j];
  S.gauss_jordan();
  const double E_y = 1. / S(1, 1);
  const auto   bar =
    section_constants(states.compliance(), section->element().center());
  check_near(bar.EA, E_y * b * h, 1e-8);
  check_near(bar.EI[0], E_y * h * b * b * b / 12., 1e-8);
  // Bent about x it twists.
  BOOST_TEST(std::abs(states.compliance()[Force::M_x][Force::M_y]) >
             0.01 * states.compliance()[Force::M_y][Force::M_y]);
}



BOOST_AUTO_TEST_CASE(wide_laminate)
{
  // [45/-45/0] against lamination theory, free at the edges: what differs falls
  // with h / b.
  double before = 1e300;
  for (const double b : {10., 30., 100.})
    {
      const Laminate laminate = rectangle(b, 1., {45., -45., 0.}, 8);
      const auto     bar = constants_of(*section_of(laminate, orthotropic, 2));
      const double   EI =
        laminate_stiffness(laminate.plies({{"material", orthotropic}}), b).EI;
      // About x, the weak axis.
      const double off = std::abs(bar.EI[1] / EI - 1.);
      BOOST_TEST(off < 0.5 * before, b << ": " << off);
      before = off;
    }
  BOOST_TEST(before < 0.01);
}



BOOST_AUTO_TEST_CASE(compliance_and_stiffness)
{
  // Inverse to each other, symmetric, positive; the same whatever the unit of
  // length, for a coupled section.
  for (const double unit : {1., 1e-3})
    {
      const auto section =
        section_of(rectangle(0.6 * unit, 0.2 * unit, {45., -45., 0.}, 4),
                   orthotropic,
                   2);
      const SaintVenant   states(*section);
      const SectionTensor product = states.compliance() * states.stiffness();
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = 0; j < 6; ++j)
          {
            const double scale =
              std::sqrt(states.compliance()[i][i] / states.compliance()[j][j]);
            BOOST_TEST(std::abs(product[i][j] - (i == j)) < 1e-9 * scale);
          }
      // Each state is in equilibrium with no load on the section's surface:
      // S_00 a = E b_1 + ... holds in the held fields, too, or the sum of
      // forces were not constant along the axis.
      for (unsigned int k = 0; k < 2; ++k)
        {
          const Vector &a = states.values()[k], &b = states.derivatives()[k];
          Vector        r(a.size()), more(a.size());
          section->S(0, 0).vmult(r, a);
          section->S(0, 1).vmult(more, b);
          r += more;
          const double scale = more.linfty_norm();
          section->S(1, 0).vmult(more, b);
          r -= more;
          BOOST_TEST(r.linfty_norm() < 1e-9 * scale);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
