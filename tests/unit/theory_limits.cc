// SPDX-License-Identifier: LGPL-2.1-or-later

// What theories cannot follow, from the section alone, against closed forms.
//
// - One ply: 1 / (k G A) = int S^2 / (G b) dz / (E I)^2 with S = E b (h^2 / 4 -
//   z^2) / 2 gives k = 5/6. The warping is cubic, so TE-3 has it, too; TE-1 and
//   TE-2 have w = c z, whose best slope gives k = 1.
// - A sandwich of thin stiff faces, t << h, over a soft core: k G A tends to
//   G_c b d^2 / c, d between the faces' middles, c the core's height.
// - Torsion of a square: G J = 0.140577 G a^4; without warping (TE-1) G a^4 /
// 6;
//   TE-4 and LE-3 of one cell 304/135 (a / 2)^4 G (see torsion.cc).

#include <lamella/section/theory.h>
#include <lamella/section/theory_limits.h>
#include <lamella/shape/shapes.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(theory_limits)

using namespace lamella;

namespace
{
  constexpr double E = 70., nu = 0.3, G = E / (2. + 2. * nu);

  const Materials constants{{"m", EngineeringConstants::isotropic(E, nu)},
                            {"soft",
                             EngineeringConstants::isotropic(1e-3 * E, nu)}};



  double
  off(const double value, const double expected)
  {
    return std::abs(value / expected - 1.);
  }
} // namespace



BOOST_AUTO_TEST_CASE(shear_of_one_ply)
{
  const Laminate one{2., {0.}, {3.}, {"m"}, {1}, {1}};
  const auto     plies = one.plies(constants);
  BOOST_TEST(off(shear_stiffness(plies, 2.), 5. / 6. * G * 6.) < 1e-12);
  BOOST_TEST(off(shear_stiffness(plies, 2., 1), G * 6.) < 1e-12);
  BOOST_TEST(off(shear_stiffness(plies, 2., 2), G * 6.) < 1e-12);
  BOOST_TEST(off(shear_stiffness(plies, 2., 3), 5. / 6. * G * 6.) < 1e-12);
  BOOST_TEST(off(shear_stiffness(plies, 2., 7), 5. / 6. * G * 6.) < 1e-10);
}



BOOST_AUTO_TEST_CASE(shear_of_a_sandwich)
{
  // Faces of 0.01 over a core of 1, a thousand times softer.
  const Laminate sandwich{
    2., {0., 0., 0.}, {0.01, 1., 0.01}, {"m", "soft", "m"}, {1}, {1}};
  const auto   plies = sandwich.plies(constants);
  const double exact = shear_stiffness(plies, 2.);
  BOOST_TEST(off(exact, 1e-3 * G * 2. * 1.01 * 1.01) < 0.05);
  // Polynomials come down to it slowly, from above.
  double previous = std::numeric_limits<double>::max();
  for (const unsigned int N : {1, 3, 5, 7, 9, 15})
    {
      const double kGA = shear_stiffness(plies, 2., N);
      BOOST_TEST(kGA > exact);
      BOOST_TEST(kGA < previous);
      previous = kGA;
    }
}



BOOST_AUTO_TEST_CASE(torsion_of_a_square)
{
  const Laminate square{2., {0.}, {2.}, {"m"}, {1}, {1}};
  const auto     mesh = make_section_mesh(square, constants);
  const auto     GJ   = [&mesh](const std::string &theory) {
    return torsional_stiffness(
      *make_section(mesh, Theory::parse({"Theory", theory})));
  };
  BOOST_TEST(!GJ("EBBT"));
  BOOST_TEST(!GJ("TBT"));
  BOOST_TEST(off(*GJ("TE-2"), G * 16. / 6.) < 1e-10);
  BOOST_TEST(off(*GJ("TE-4"), G * 304. / 135.) < 1e-10);
  BOOST_TEST(off(*GJ("LE-3"), G * 304. / 135.) < 1e-10);
  BOOST_TEST(off(*GJ("TE-12"), 0.1405770 * 16. * G) < 1e-5);
}

BOOST_AUTO_TEST_SUITE_END()
