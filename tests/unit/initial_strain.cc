// SPDX-License-Identifier: LGPL-2.1-or-later

// sigma = C (eps - eps_0), and rows with a constant part.

#include "fixtures.h"

#include <lamella/body/fields.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(initial_strain)

using namespace lamella;

namespace
{
  const EngineeringConstants
    orthotropic{165., 9., 8., 5.6, 5.2, 2.8, 0.34, 0.3, 0.45};

  Voigt
  any_strain(const double seed)
  {
    Voigt strain;
    for (unsigned int c = 0; c < 6; ++c)
      strain[c] = std::sin(seed + 1.7 * c);
    return strain;
  }
} // namespace

BOOST_AUTO_TEST_CASE(law)
{
  const ElasticTensor C   = rotated(orthotropic.stiffness(), ply_axes(30.));
  const Voigt         eps = any_strain(1.), eps_0 = any_strain(2.);
  const ElasticLaw    law(C, eps_0), without(C);
  // Free expansion has neither stress nor energy.
  BOOST_TEST(law.stress(eps_0).norm() == 0.);
  BOOST_TEST(law.energy_density(eps_0) == 0.);
  BOOST_TEST((law.stress(eps) - (C * eps - C * eps_0)).norm() < 1e-12);
  BOOST_TEST((without.stress(eps) - C * eps).norm() == 0.);
  // The stress is the energy's derivative.
  const Voigt  d = any_strain(3.);
  const double h = 1e-4;
  const double two =
    law.energy_density(eps + h * d) - law.energy_density(eps - h * d);
  BOOST_TEST(std::abs(two / (2. * h) - law.stress(eps) * d) < 1e-9);
}



BOOST_AUTO_TEST_CASE(fields_of_a_strain)
{
  // Stress rows are affine in the strain; what they say is what samples say,
  // in both frames.
  const Triad     ply = ply_axes(-20.);
  const Placement placement =
    Placement::from_directions({0., 0., 0.},
                               dealii::Point<3>(1., 2., 0.5),
                               dealii::Point<3>(0., 0.2, 1.));
  const ElasticLaw law(rotated(orthotropic.stiffness(), ply), any_strain(2.));
  const Voigt      eps    = any_strain(1.);
  const auto       sample = sample_of({}, eps, placement, ply, law);
  const auto       by_row = [&](const Quantity what, const Frame frame) {
    const StrainMap map = make_strain_map(what, frame, placement, ply, law);
    return map.matrix * eps + map.constant;
  };
  BOOST_TEST((by_row(Quantity::stress, Frame::scene) - sample.stress).norm() <
             1e-11);
  BOOST_TEST((by_row(Quantity::stress, Frame::ply) - sample.ply_stress).norm() <
             1e-11);
  BOOST_TEST((by_row(Quantity::strain, Frame::scene) - sample.strain).norm() <
             1e-13);
}



BOOST_AUTO_TEST_CASE(rows)
{
  // r(u) = 3 + 2 u_0 - u_2; its load is that of the linear part.
  LinearFunctional row;
  row.add(0, 2.);
  row.add(2, -1.);
  row.add_constant(3.);
  Vector u(3), f(3);
  u[0] = 5.;
  u[2] = 7.;
  BOOST_TEST(row(u) == 6.);
  row.add_to(f, 10.);
  BOOST_TEST(f[0] == 20.);
  BOOST_TEST(f[2] == -10.);

  LinearFunctional twice;
  twice.add(row, 2.);
  BOOST_TEST(twice(u) == 12.);

  // u_2 = 4 u_1: the constant stays.
  Constraints constraints;
  constraints.add_line(2);
  constraints.add_entry(2, 1, 4.);
  constraints.close();
  u[1] = 7. / 4.;
  BOOST_TEST(row.reduced(constraints)(u) == 6.);
}

BOOST_AUTO_TEST_SUITE_END()
