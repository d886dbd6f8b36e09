// SPDX-License-Identifier: LGPL-2.1-or-later

// Laws of interface points: traction and tangent are the derivatives of the
// energy, by central differences, and the law of Coulomb holds line by line.

#include <lamella/contact/interface_law.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

BOOST_AUTO_TEST_SUITE(interface_law)

using namespace lamella;
using dealii::Tensor;

namespace
{
  constexpr double mu = 0.4, step = 1e-5;

  /// Trial tractions of all states, none within the step of a change of state.
  std::vector<Tensor<1, 3>>
  trials()
  {
    std::mt19937                     random(1);
    std::normal_distribution<double> normal;
    std::vector<Tensor<1, 3>>        result;
    while (result.size() < 200)
      {
        const Tensor<1, 3> z(
          {normal(random), 0.5 * normal(random), 0.5 * normal(random)});
        if (std::abs(z[0]) > 10. * step &&
            std::abs(std::hypot(z[1], z[2]) - mu * z[0]) > 10. * step)
          result.push_back(z);
      }
    return result;
  }



  Tensor<1, 3>
  moved(Tensor<1, 3> z, const unsigned int component, const double by)
  {
    z[component] += by;
    return z;
  }



  /// Compares the derivatives of @p law at @p z with central differences.
  void
  compare_with_differences(const InterfaceLaw &law, const Tensor<1, 3> &z)
  {
    constexpr double        accurate = 1e-8;
    const ShearBound        bound    = law.bound(z);
    const InterfaceResponse at       = law.evaluate(z, bound.value);
    for (unsigned int c = 0; c < 3; ++c)
      {
        const Tensor<1, 3> up = moved(z, c, step), down = moved(z, c, -step);
        const InterfaceResponse more = law.evaluate(up, bound.value),
                                less = law.evaluate(down, bound.value);
        BOOST_TEST(std::abs((more.energy - less.energy) / (2. * step) -
                            at.traction[c]) < accurate);
        BOOST_TEST(
          std::abs((law.bound(up).value - law.bound(down).value) / (2. * step) -
                   bound.gradient[c]) < accurate);
        for (unsigned int i = 0; i < 3; ++i)
          BOOST_TEST(
            std::abs((more.traction[i] - less.traction[i]) / (2. * step) -
                     at.tangent[i][c]) < accurate);
      }
    const Tensor<1, 3> by_bound =
      (law.evaluate(z, bound.value + step).traction -
       law.evaluate(z, bound.value - step).traction) /
      (2. * step);
    BOOST_TEST((by_bound - at.bound_derivative).norm() < accurate);
  }
} // namespace



BOOST_AUTO_TEST_CASE(derivatives_are_those_of_the_energy)
{
  unsigned int n[3] = {0, 0, 0};
  for (const Tensor<1, 3> &z : trials())
    {
      const CoulombFriction friction(mu);
      compare_with_differences(UnilateralContact(), z);
      compare_with_differences(friction, z);
      compare_with_differences(TiedInterface(), z);
      ++n[int(friction.evaluate(z, friction.bound(z).value).state)];
    }
  // Each state is among them.
  BOOST_TEST(std::min({n[0], n[1], n[2]}) > 10u);
}



BOOST_AUTO_TEST_CASE(the_projection_is_the_nearest_point_of_the_convex_set)
{
  // (z - P) . (x - P) <= 0 for all x with x_n >= 0, |x_t| <= b.
  for (const Tensor<1, 3> &z : trials())
    {
      const CoulombFriction law(mu);
      const double          b = law.bound(z).value;
      const Tensor<1, 3>    P = law.evaluate(z, b).traction;
      for (const double n : {0., 0.7, 2.})
        for (unsigned int k = 0; k < 8; ++k)
          {
            const Tensor<1, 3> x(
              {n, b * std::cos(0.8 * k), b * std::sin(0.8 * k)});
            BOOST_TEST((z - P) * (x - P) < 1e-14);
          }
      BOOST_TEST(P[0] >= 0.);
      BOOST_TEST(std::hypot(P[1], P[2]) <= mu * P[0] + 1e-15);
    }
}



BOOST_AUTO_TEST_CASE(slip_opposes_the_shear_force)
{
  // A point under the force lambda that slips by v against it: the natural map
  // is zero, for any stiffness.
  const CoulombFriction law(mu);
  const Tensor<1, 3>    lambda({2., 0.6 * mu * 2., 0.8 * mu * 2.}),
    v({0., -0.3, -0.4});
  for (const double D : {0.1, 1., 30.})
    {
      const Tensor<1, 3>      z  = lambda - D * v;
      const InterfaceResponse at = law.evaluate(z, law.bound(z).value);
      BOOST_TEST((at.state == PointState::slip));
      BOOST_TEST((at.traction - lambda).norm() < 1e-14);
    }
}

BOOST_AUTO_TEST_SUITE_END()
