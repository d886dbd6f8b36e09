// SPDX-License-Identifier: LGPL-2.1-or-later

// Saint-Venant torsion: J = T / (G theta') between two sections away from the
// ends, against closed forms. Only warping makes it right, so it tells the
// theories apart.
//
// With the warping u_y = psi(x, z) theta' about the center,
//   J = min over psi of int (psi_x + z)^2 + (psi_z - x)^2 dA,
// which each theory minimizes over the warping functions that it has:
// - none (TE-1): J = I_p = I_x + I_z, of a square a^4 / 6 instead of
//   0.140577 a^4, 18.6 % too stiff;
// - c x z (TE-2, TE-3, LE-1 and LE-2 of one cell): (c + 1)^2 I_z + (c - 1)^2
//   I_x is least for c = (I_x - I_z) / (I_x + I_z): J = 4 I_x I_z / (I_x +
//   I_z). Of a square still I_p; of an ellipse exact;
// - c (x^3 z - x z^3), of a square (TE-4, TE-5, LE-3 and LE-4 of one cell; all
//   others are of another symmetry): on [-1, 1]^2 the product with (z, -x) is
//   6 * 4/9 - 2 * 4/5 = 16/15, the square of the gradient 6 * 4/15 + 8/7 =
//   96/35, so J = 8/3 - (16/15)^2 / (96/35) = 304/135 = 2.251852, of a^4 / 16
//   each: 0.12 % too stiff.
// x, z from the center; I_x = int x^2, I_z = int z^2.

#include "fixtures.h"

#include <lamella/shape/shapes.h>

#include <boost/test/unit_test.hpp>

#include <iomanip>

BOOST_AUTO_TEST_SUITE(torsion)

using namespace lamella;
using dealii::Point;
using dealii::numbers::PI;

namespace
{
  constexpr double E = 70., nu = 0.3, G = E / (2. + 2. * nu);

  const Materials constants{
    {"material", EngineeringConstants::isotropic(E, nu)}};

  struct Bar
  {
    SectionShape shape;
    double       width, height, polar_moment;
  };



  Bar
  rectangular(const double width, const double height, Laminate laminate)
  {
    return {laminate,
            width,
            height,
            width * height * (width * width + height * height) / 12.};
  }



  /// Of a rectangle, a >= b: a b^3 / 3 (1 - 192 b / (pi^5 a) sum over odd n of
  /// tanh(n pi a / 2 b) / n^5) (Timoshenko and Goodier, Sec. 109). After n = 39
  /// the rest is below int n^-5 / 2 = 1 / (8 * 40^4) = 5e-8.
  double
  rectangle_constant(const double a, const double b)
  {
    double sum = 0.;
    for (unsigned int n = 1; n < 40; n += 2)
      sum += std::tanh(n * PI * a / (2. * b)) / std::pow(n, 5);
    return a * b * b * b / 3. * (1. - 192. * b / (std::pow(PI, 5) * a) * sum);
  }



  Support
  held_at(const std::string &name, const std::vector<Point<3>> &points)
  {
    return {name,
            {{0, Region::Kind::point, "", points}},
            {{std::nullopt, 0., std::nullopt}}};
  }



  /**
   * T / (G theta') in the middle of a bar of ten of its larger sides. Its start
   * does not turn but warps freely: u_y vanishes at three points on the axes of
   * symmetry, where warping does. At its end tractions as those of a turn make
   * the torque; elements of a side's length there take in how they differ
   * from Saint-Venant's, which decays with a distance of a side or less.
   */
  double
  torsion_constant(const Bar &bar, const std::string &theory)
  {
    const double W = bar.width, H = bar.height, D = std::max(W, H), L = 10. * D;
    AxisMesh     mesh;
    mesh.length   = L;
    mesh.elements = {1, 1, 2};
    mesh.breaks   = {0.4 * L, L - 2. * D};
    const Support start{"start",
                        {{0, Region::Kind::surface, "start", {}}},
                        {{0., std::nullopt, 0.}}};
    const Solved  solved = solve_linear(
      std::make_unique<Beam>("bar",
                             make_section(make_section_mesh(bar.shape,
                                                            constants),
                                          Theory::parse({"Theory", theory})),
                             std::make_shared<Axis>(mesh),
                             Placement()),
      {start,
        held_at(
         "points",
         {{W / 2., 0., H / 2.}, {0.9 * W, 0., H / 2.}, {W / 2., 0., 0.9 * H}})},
      {traction(
        "end",
        digits(-1. / bar.polar_moment) + " * (z - " + digits(H / 2.) + ")",
        "0",
        digits(1. / bar.polar_moment) + " * (x - " + digits(W / 2.) + ")")});
    // The turn about y takes x to -z. Of wide sections u_z along x tells it.
    const auto rotation = [&](const double y) {
      return W >= H ? (solved.at({0.8 * W, y, H / 2.}).displacement[2] -
                       solved.at({0.2 * W, y, H / 2.}).displacement[2]) /
                        (0.6 * W) :
                      (solved.at({W / 2., y, 0.2 * H}).displacement[0] -
                       solved.at({W / 2., y, 0.8 * H}).displacement[0]) /
                        (0.6 * H);
    };
    return 0.3 * L / (G * (rotation(0.5 * L) - rotation(0.2 * L)));
  }



  /// J over the closed form, also as a line of a table.
  double
  ratio(const std::string &name,
        const Bar         &bar,
        const std::string &theory,
        const double       exact)
  {
    const double value = torsion_constant(bar, theory) / exact;
    BOOST_TEST_MESSAGE("| " << name << " | " << theory << " | "
                            << std::setprecision(3) << 100. * (value - 1.)
                            << " |");
    return value;
  }
} // namespace

BOOST_AUTO_TEST_CASE(square)
{
  BOOST_TEST_MESSAGE("| section | theory | error of J in % |");
  const double exact = rectangle_constant(1., 1.);
  BOOST_TEST(std::abs(exact - 0.140577) < 5e-7);
  const Bar one      = rectangular(1., 1., rectangle(1., 1.)),
            four     = rectangular(1., 1., rectangle(1., 1., {0.}, 2, 2));
  const double polar = 1. / 6. / exact, quartic = 304. / 135. / 16. / exact;
  BOOST_TEST(std::abs(polar - 1.186) < 5e-4);
  for (const auto &[theory, expected] : {std::make_pair("TE-1", polar),
                                         {"TE-2", polar},
                                         {"TE-3", polar},
                                         {"TE-4", quartic},
                                         {"TE-5", quartic},
                                         {"LE-1", polar},
                                         {"LE-2", polar},
                                         {"LE-3", quartic},
                                         {"LE-4", quartic}})
    BOOST_TEST(std::abs(ratio("square", one, theory, exact) - expected) < 1e-4);
  // More warping, less stiffness, never less than exact.
  double previous = quartic;
  for (const char *theory : {"TE-6", "TE-8"})
    {
      const double value = ratio("square", one, theory, exact);
      BOOST_TEST(value < previous + 1e-6);
      BOOST_TEST(value > 1. - 1e-5);
      previous = value;
    }
  previous = polar;
  for (const char *theory : {"LE-1", "LE-2", "LE-3"})
    {
      const double value = ratio("square, 2 x 2", four, theory, exact);
      BOOST_TEST(value < previous + 1e-6);
      BOOST_TEST(value > 1. - 1e-5);
      previous = value;
    }
  BOOST_TEST(previous < 1.005);
}



BOOST_AUTO_TEST_CASE(thin_rectangle)
{
  // W/h = 10: (10/3) (1 - 0.63 / 10) = 3.123 h^4. With c x z alone J = 4 I_x
  // I_z / (I_x + I_z) = 1000 / 303. Along the width warping is x z but for the
  // last height at either edge, which polynomials of the whole section find it
  // hard to follow: LE with cells of that size does it.
  const double W = 10., exact = rectangle_constant(W, 1.);
  BOOST_TEST(std::abs(exact / (W / 3.) - 0.937) < 5e-4);
  Laminate  laminate     = rectangle(W, 1.);
  const Bar one          = rectangular(W, 1., laminate);
  laminate.cells_across  = {1, 1, 1};
  laminate.across_breaks = {1., 9.};
  const Bar    graded    = rectangular(W, 1., laminate);
  const double polar     = W * (W * W + 1.) / 12. / exact,
               bilinear  = W * W * W / (3. * (W * W + 1.)) / exact;
  BOOST_TEST(std::abs(ratio("W/h = 10", one, "TE-1", exact) / polar - 1.) <
             1e-4);
  for (const char *theory : {"TE-2", "LE-1"})
    BOOST_TEST(std::abs(ratio("W/h = 10", one, theory, exact) - bilinear) <
               1e-4);
  double previous = bilinear;
  for (const char *theory : {"TE-4", "TE-6", "TE-8"})
    {
      const double value = ratio("W/h = 10", one, theory, exact);
      BOOST_TEST(value < previous);
      BOOST_TEST(value > 1.);
      previous = value;
    }
  previous = bilinear;
  for (const char *theory : {"LE-2", "LE-3", "LE-4"})
    {
      const double value = ratio("W/h = 10, 3 cells", graded, theory, exact);
      BOOST_TEST(value < previous);
      BOOST_TEST(value > 1. - 1e-5);
      previous = value;
    }
  BOOST_TEST(previous < 1.005);
}



BOOST_AUTO_TEST_CASE(ellipse)
{
  // pi a^3 b^3 / (a^2 + b^2); its warping is c x z, which all but TE-1 have,
  // and TE-1's I_p = pi a b (a^2 + b^2) / 4 is ((a^2 + b^2) / 2 a b)^2 of it:
  // 25/16 for a = 2 b. What is left is the shape of the mesh: J is of fourth
  // order in lengths, the area of second, so twice the error of the area if the
  // whole arc is off alike; eight times that is allowed.
  for (const auto &[width, height] :
       {std::make_pair(2., 1.), std::make_pair(1., 2.)})
    {
      const double a = width / 2., b = height / 2.;
      const double exact =
        PI * std::pow(a, 3) * std::pow(b, 3) / (a * a + b * b);
      const SectionShape shape = Ellipse{width, height, 0, {"material", 0.}};
      const Bar bar{shape, width, height, PI * a * b * (a * a + b * b) / 4.};
      const std::string name = width > height ? "ellipse" : "upright ellipse";
      const auto check = [&](const std::string &theory, const double expected) {
        const double area = make_section(make_section_mesh(shape, constants),
                                         Theory::parse({"Theory", theory}))
                              ->area();
        BOOST_TEST(std::abs(ratio(name, bar, theory, exact) / expected - 1.) <
                   8. * std::abs(area / (PI * a * b) - 1.) + 1e-5);
      };
      check("TE-1", 25. / 16.);
      for (const char *theory : {"TE-2", "TE-3"})
        check(theory, 1.);
      if (width > height)
        for (const char *theory : {"LE-2", "LE-3"})
          check(theory, 1.);
    }
}

BOOST_AUTO_TEST_SUITE_END()
