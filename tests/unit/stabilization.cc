// SPDX-License-Identifier: LGPL-2.1-or-later

// Springs in the free rigid motions of bodies that contact alone holds.

#include "fixtures.h"

#include <lamella/base/exceptions.h>
#include <lamella/conditions/stabilization.h>
#include <lamella/solve/checks.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(stabilization)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  // 0.4 x 0.3, length 2, turned in space.
  std::unique_ptr<Body>
  bar(const std::string &theory)
  {
    const auto mesh =
      make_section_mesh(rectangle(0.4, 0.3, {0.}, 2),
                        {{"material",
                          EngineeringConstants::isotropic(10., 0.)}});
    const Placement placement =
      Placement::from_directions({0.3, 0., 0.1},
                                 Point<3>(1., 2., 0.5),
                                 Point<3>(0., 0.2, 1.));
    return std::make_unique<Beam>(
      "bar",
      make_section(mesh, Theory::parse({"Theory", theory})),
      make_axis(2., 2),
      placement);
  }
} // namespace

BOOST_AUTO_TEST_CASE(a_spring_for_each_free_motion)
{
  // TBT cannot turn about its axis: five motions. The springs see all rigid
  // motions that the theory has (none of their combinations leaves all springs
  // at rest), and the stiffness is share E A / L = share * 10 * 0.12 / 2.
  for (const auto &[theory, n] :
       {std::make_pair("LE-2", 6u), std::make_pair("TBT", 5u)})
    {
      const auto body    = bar(theory);
      const auto springs = stabilizing_springs(*body, 0, {}, {1e-3});
      BOOST_REQUIRE(springs.size() == n);
      const auto motions = body->rigid_motions(undisplaced);
      dealii::LAPACKFullMatrix<double> lengths(n, 6);
      for (unsigned int k = 0; k < n; ++k)
        {
          BOOST_TEST(std::abs(springs[k].stiffness / (1e-3 * 0.6) - 1.) <
                     1e-12);
          for (unsigned int m = 0; m < 6; ++m)
            lengths(k, m) = springs[k].row(motions[m]);
        }
      lengths.compute_svd();
      BOOST_TEST(lengths.singular_value(n - 1) > 0.1);
    }
}



BOOST_AUTO_TEST_CASE(what_is_held_gets_no_spring)
{
  // Held along the scene's x and z everywhere at its start: y is free.
  Bodies bodies;
  bodies.push_back(bar("LE-2"));
  const Support half{"half",
                     {{0, Region::Kind::body, "", {}}},
                     {{0., std::nullopt, 0.}}};
  const auto    rows = prescribed_functionals({half}, bodies);
  const auto    springs =
    stabilizing_springs(*bodies[0], 0, rows, Stabilization{1e-3});
  BOOST_REQUIRE(springs.size() == 1);
  BOOST_TEST(springs[0].motion == "translation along y");
  // Four points, each of weight 1/2: a unit translation is 2 long.
  const auto motions = bodies[0]->rigid_motions(undisplaced);
  BOOST_TEST(std::abs(std::abs(springs[0].row(motions[1])) - 2.) < 1e-12);
  BOOST_TEST(std::abs(springs[0].row(motions[0])) < 1e-12);
  BOOST_TEST(stabilizing_springs(*bodies[0], 0, rows, {0.}).empty());
}



BOOST_AUTO_TEST_CASE(a_free_bar_on_springs)
{
  // A force F at the middle of the bar along y against the one spring:
  // 1/2 k (2 u)^2 = F u / 2, u = F / (4 k), and the bar moves as a whole.
  const auto     body = bar("LE-2");
  const Support  half{"half",
                     {{0, Region::Kind::body, "", {}}},
                     {{0., std::nullopt, 0.}}};
  const Point<3> center = body->center();
  const Load     push{"push",
                  {{0, Region::Kind::point, "", {center}}},
                  {{"0", "1e-6", "0"}},
                  ""};
  Bodies         bodies;
  bodies.push_back(bar("LE-2"));
  Structure structure(std::move(bodies), {half}, {push}, {{1e-5}});
  const std::vector<GapConstraint> none;
  const State  state = LinearSystem(linearized(structure), none).solve_free(1.);
  const double k     = 1e-5 * 0.6;
  const auto   where = structure.bodies()[0]->locate({center}).at(0).at(0);
  const double u =
    structure.bodies()[0]->sample(where, state.u.block(0)).displacement[1];
  BOOST_TEST(std::abs(u / (1e-6 / (4. * k)) - 1.) < 1e-3);

  const Checks checks =
    check_state(TangentOperator(structure, state.u), {}, 1, state, 1.);
  BOOST_TEST(checks.force_balance < 1e-9);
  BOOST_TEST(checks.energy_balance < 1e-9);
  BOOST_TEST(checks.stabilization_share > 0.99);
  BOOST_CHECK_THROW(check_solution(state, checks, 100.), NumericsError);
}

BOOST_AUTO_TEST_SUITE_END()
