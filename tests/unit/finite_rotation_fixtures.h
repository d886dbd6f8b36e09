// SPDX-License-Identifier: LGPL-2.1-or-later

// What tests of bodies that turn by any angle share.

#ifndef lamella_tests_finite_rotation_fixtures_h
#define lamella_tests_finite_rotation_fixtures_h

#include "fixtures.h"

#include <boost/test/unit_test.hpp>

#include <random>

namespace lamella
{
  /// Nine constants, all different.
  inline Material
  nine_constants()
  {
    EngineeringConstants c;
    c.E1   = 10.;
    c.E2   = 2.;
    c.E3   = 1.5;
    c.G12  = 0.9;
    c.G13  = 0.8;
    c.G23  = 0.6;
    c.nu12 = 0.3;
    c.nu13 = 0.25;
    c.nu23 = 0.35;
    Material material(c);
    material.expansion = dealii::Tensor<1, 3>({0.1, 0.3, -0.2});
    return material;
  }

  /// @p n numbers between -@p size and @p size, the same for a @p seed.
  inline Vector
  random_vector(const unsigned int n,
                const double       size,
                const unsigned int seed)
  {
    std::mt19937                           generator(seed);
    std::uniform_real_distribution<double> number(-size, size);
    Vector                                 v(n);
    for (double &entry : v)
      entry = number(generator);
    return v;
  }

  /// What heat does to @p body in the state @p u is a derivative of its energy,
  /// and has its own.
  inline void
  check_heat(Body &body, const Vector &u)
  {
    body.heat(
      [](const dealii::Point<3> &x) { return 0.3 + 0.1 * x[1] - 0.2 * x[0]; });
    constexpr double h              = 1e-5;
    const auto       thermal_factor = [&](const Vector &at) {
      Vector f(at.size());
      body.add_thermal_load(at, f);
      return f;
    };
    for (const unsigned int seed : {3, 4, 5})
      {
        const Vector w    = random_vector(body.n_dofs(), 1., seed);
        Vector       step = w;
        step *= h;
        const Vector ahead = body.retract(u, step);
        step *= -1.;
        const Vector back = body.retract(u, step);
        Vector       f(u.size()), derivative(u.size());
        body.add_internal_forces(u, f);
        f -= thermal_factor(u);
        const double work = f * w;
        BOOST_TEST(std::abs((body.deformation(ahead).energy -
                             body.deformation(back).energy) /
                              (2. * h) -
                            work) < 1e-7 * std::abs(work));
        const double second =
          (thermal_factor(ahead) * w - thermal_factor(back) * w) / (2. * h);
        body.for_each_thermal_block(u, [&](const StiffnessBlock &block) {
          block.add_product(w, derivative);
        });
        BOOST_TEST(std::abs(derivative * w - second) < 1e-7 * std::abs(second));
      }
    Vector rest(u.size()), start(u.size());
    body.add_thermal_load(undisplaced, start);
    const double size = start.l2_norm();
    start -= thermal_factor(rest);
    BOOST_TEST(size > 0.);
    BOOST_TEST(start.l2_norm() < 1e-12 * size);
  }
} // namespace lamella

#endif
