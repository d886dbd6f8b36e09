// SPDX-License-Identifier: LGPL-2.1-or-later

// Integrals of loads over cells by composite Gauss rules, against integrals by
// hand.

#include <lamella/conditions/load.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

BOOST_AUTO_TEST_SUITE(load_moments)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /// One cell, degrees 1 and 3, with the force f(s, t) along z.
  template <typename Function>
  LoadMoments
  integrate(const Function &f, const double long_side = 1.)
  {
    return lamella::load_moments(
      {{[f](const Point<2> &x) { return Point<3>(0., 0., f(x[0], x[1])); },
        {{1, 3}},
        {{1., long_side}}}});
  }



  double
  sum(const LoadMoments &moments)
  {
    double result = 0.;
    for (const Tensor<1, 3> &moment : moments.of_cells[0])
      result += moment[2];
    return result;
  }
} // namespace



BOOST_AUTO_TEST_CASE(polynomials_at_once)
{
  // The rule of degree + 3 points is exact.
  const LoadMoments moments =
    integrate([](const double s, const double t) { return s * t * t; });
  BOOST_TEST(std::abs(sum(moments) - 1. / 6.) < 1e-14);
  BOOST_TEST(moments.unresolved < 1e-14);
  // phi_0 along s is 1 - s, along t that of the first Gauss-Lobatto node.
  double at_start = 0.;
  for (unsigned int j = 0; j < 4; ++j)
    at_start += moments.of_cells[0][2 * j][2];
  BOOST_TEST(std::abs(at_start - 1. / 18.) < 1e-14);
}



BOOST_AUTO_TEST_CASE(edges_of_a_strip)
{
  for (const auto &[low, high] : {std::make_pair(0.312, 0.577),
                                  std::make_pair(0.60001, 0.6081),
                                  std::make_pair(0.98, 1.)})
    {
      const LoadMoments moments = integrate(
        [low = low, high = high](const double, const double t) {
          return t > low && t < high ? 2. : 0.;
        },
        20.);
      BOOST_TEST(std::abs(sum(moments) / (2. * (high - low)) - 1.) < 1e-7);
      BOOST_TEST(moments.error < 1e-7 * moments.size);
    }
}



BOOST_AUTO_TEST_CASE(waves)
{
  const double      k       = 2. * dealii::numbers::PI * 9.;
  const LoadMoments moments = integrate(
    [k](const double, const double t) { return std::pow(std::sin(k * t), 2); });
  BOOST_TEST(std::abs(sum(moments) - 0.5) < 1e-9);
}



BOOST_AUTO_TEST_CASE(a_round_patch)
{
  // Edges across both parameters, with an estimate that covers the error.
  const LoadMoments moments = integrate([](const double s, const double t) {
    return std::hypot(s - 0.41, t - 0.53) < 0.27 ? 1. : 0.;
  });
  const double      exact   = dealii::numbers::PI * 0.27 * 0.27;
  BOOST_TEST(std::abs(sum(moments) - exact) < 3e-4 * exact);
  BOOST_TEST(std::abs(sum(moments) - exact) < moments.error);
}



BOOST_AUTO_TEST_CASE(a_narrow_strip)
{
  // 0.0034 of the length, and an error of one rule for the whole cell.
  const LoadMoments moments =
    integrate([](const double,
                 const double t) { return t > 0.6006 && t < 0.604 ? 1. : 0.; },
              10.);
  BOOST_TEST(std::abs(sum(moments) / 0.0034 - 1.) < 1e-8);
  BOOST_TEST(moments.unresolved > 0.1 * 0.0034);
}



BOOST_AUTO_TEST_CASE(nothing_and_constants)
{
  const LoadMoments nothing =
    integrate([](const double, const double) { return 0.; });
  BOOST_TEST(nothing.size == 0.);
  BOOST_TEST(sum(nothing) == 0.);
  const LoadMoments constant = lamella::load_moments(
    {{[](const Point<2> &) { return Point<3>(1., 2., 3.); },
      {{3, 0}},
      {{1., 0.}}}});
  double total = 0.;
  for (const Tensor<1, 3> &moment : constant.of_cells[0])
    total += moment[1];
  BOOST_TEST(std::abs(total - 2.) < 1e-14);
}

BOOST_AUTO_TEST_SUITE_END()
