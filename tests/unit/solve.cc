// SPDX-License-Identifier: LGPL-2.1-or-later

// Newton loop, strategies and checks on scenes with a closed form.

#include "contact_scene.h"

#include <lamella/base/exceptions.h>
#include <lamella/contact/gap_constraints.h>
#include <lamella/solve/checks.h>
#include <lamella/solve/contact_strategy.h>
#include <lamella/solve/nonlinear_solver.h>
#include <lamella/solve/parameters.h>
#include <lamella/solve/penalty_matrix.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(solve)

using namespace lamella;
using dealii::Point;

namespace
{
  constexpr double E = 200., side = 1.5, penalty = 700., gap = 0.01,
                   press = 0.05;

  /// Two cubes of the side 1.5, one above the other with a gap; the lower one
  /// stands on a fixed floor, the upper one's top is moved down. nu = 0, so the
  /// stress is uniform.
  struct TwoCubes
  {
    TwoCubes(const double moved, const double nu = 0.)
    {
      const auto section = make_section(rectangle(side, side, {0.}, 2, 2),
                                        EngineeringConstants::isotropic(E, nu),
                                        2);
      const auto axis    = make_axis(side, 2, 2);
      Bodies     bodies;
      Placement  above;
      above.origin = Point<3>(0., 0., side + gap);
      bodies.push_back(std::make_unique<Beam>("upper", section, axis, above));
      bodies.push_back(
        std::make_unique<Beam>("lower", section, axis, Placement()));

      using Kind = Region::Kind;
      const Region top{0, Kind::surface, "top", {}},
        floor{1, Kind::surface, "bottom", {}},
        upper_face{0, Kind::surface, "bottom", {}},
        lower_face{1, Kind::surface, "top", {}};
      ContactPair pair;
      pair.name           = "faces";
      pair.first          = upper_face;
      pair.second         = lower_face;
      pair.discretization = Discretization::node_to_node;
      pair.enforcement    = Enforcement::penalty;
      pair.penalty        = {PenaltyKind::per_area, penalty};
      contacts.push_back(make_interface(pair, bodies));
      const Support moves{"press", {top}, {{0., 0., -moved}}},
        stands{"floor", {floor}, {{0., 0., 0.}}};
      structure =
        std::make_unique<Structure>(std::move(bodies),
                                    std::vector<Support>{moves, stands},
                                    std::vector<Load>());
    }

    State
    solve(const Strategy strategy)
    {
      const auto solver = linear_system(strategy, *structure, contacts[0].rows);
      return NonlinearSolver(*solver).solve(1.).state;
    }

    TangentOperator
    tangent(const State &state) const
    {
      return {*structure, state.u};
    }

    std::vector<ContactInterface> contacts;
    std::unique_ptr<Structure>    structure;
  };
} // namespace

BOOST_AUTO_TEST_CASE(two_cubes_pressure_and_penetration)
{
  // Springs in series, per area: two cubes of stiffness E / side and the
  // penalty. p = (press - gap) / (2 side / E + 1 / penalty).
  const double p = (press - gap) / (2. * side / E + 1. / penalty);

  TwoCubes     scene(press);
  const State  state = scene.solve(Strategy::condensed);
  const Checks checks =
    check_state(scene.tangent(state), scene.contacts, 2, state, 1.);
  BOOST_TEST(state.active.size() == scene.contacts[0].rows.size());
  for (unsigned int i = 0; i < state.force.size(); ++i)
    {
      const double area = scene.contacts[0].points[i].area;
      const double g    = scene.contacts[0].rows[i].gap(state.u, 1.);
      BOOST_TEST(std::abs(state.force[i] / area / p - 1.) < 1e-10);
      // The law itself: pressure = penalty times penetration.
      BOOST_TEST(std::abs(-penalty * g / p - 1.) < 1e-10);
    }

  // On the lower cube downwards, the same from its floor, and the energies.
  const double force = p * side * side;
  BOOST_TEST(std::abs(checks.contacts[0].force[2] / -force - 1.) < 1e-10);
  BOOST_TEST(std::abs(checks.reactions[1].force[2] / force - 1.) < 1e-10);
  // It acts in the middle of the face, and has a moment about the origin.
  const Point<3> middle(0.5 * side, 0.5 * side, side + gap);
  BOOST_TEST(checks.contacts[0].center_of_pressure.distance(middle) <
             1e-10 * side);
  const dealii::Tensor<1, 3> moment =
    Point<3>(-0.5 * side * force, 0.5 * side * force, 0.);
  BOOST_TEST((checks.contacts[0].moment - moment).norm() < 1e-10 * force);
  BOOST_TEST(checks.contacts[0].imbalance < 1e-12);
  BOOST_TEST(checks.contacts[0].violation < 1e-12);
  BOOST_TEST(std::abs(checks.reactions[0].force[2] / -force - 1.) < 1e-10);
  BOOST_TEST(std::abs(checks.energy / (p * p / E * side * side * side) - 1.) <
             1e-10);
  // Half the upper face's force times its displacement; the difference to the
  // energy is the contact's.
  BOOST_TEST(std::abs(checks.external_work / (0.5 * force * press) - 1.) <
             1e-10);
  BOOST_TEST(checks.energy_balance < 1e-10);
  BOOST_TEST(checks.contacts[0].law_error < 1e-14);
  BOOST_TEST(checks.force_balance < 1e-12);
  BOOST_TEST(checks.residual < 1e-12);
  BOOST_TEST(checks.contacts[0].complementarity == 0.);
}



BOOST_AUTO_TEST_CASE(condensed_and_full_agree)
{
  // Poisson's ratio and clamped faces: no uniform stress, no closed form, but
  // two ways that share neither factorization nor compliance.
  TwoCubes    scene(press, 0.3);
  const State condensed = scene.solve(Strategy::condensed),
              full      = scene.solve(Strategy::full);
  BOOST_TEST(condensed.active == full.active);
  BlockVector difference = condensed.u;
  difference -= full.u;
  BOOST_TEST(difference.linfty_norm() < 1e-10 * full.u.linfty_norm());
  for (unsigned int i = 0; i < full.force.size(); ++i)
    BOOST_TEST(std::abs(condensed.force[i] - full.force[i]) < 1e-10);
}



BOOST_AUTO_TEST_CASE(strategies_balance_the_residual)
{
  // Nodal forces that the state does not balance press a part of the faces
  // together.
  const TwoCubes       scene(press, 0.3);
  const GapConstraints rows(scene.contacts);
  const auto           about = linearized(*scene.structure);
  ContactProblem       problem;
  problem.gap.assign(rows.size(), gap);
  problem.force = problem.estimate = std::vector<double>(rows.size(), 0.);
  problem.residual                 = scene.structure->zero();
  for (unsigned int i = 0; i < problem.residual.size(); ++i)
    problem.residual[i] = E * side * gap * std::sin(1. + i * i);

  std::vector<ContactSolution> found;
  for (const Strategy which : {Strategy::condensed, Strategy::full})
    {
      found.push_back(
        make_strategy(which, *about, rows)->solve(problem, [](const Round &) {
        }));
      BlockVector left = about->apply(found.back().du);
      left *= -1.;
      left += problem.residual;
      for (const unsigned int r : found.back().active)
        add_force(rows[r], found.back().force[r], {}, left);
      about->condense(left);
      BOOST_TEST(left.linfty_norm() < 1e-9 * problem.residual.linfty_norm());
    }
  BOOST_TEST(found[0].active == found[1].active);
  BOOST_TEST(found[0].active.size() > 0u);
  BOOST_TEST(found[0].active.size() < rows.size());

  // The product of the assembled matrix is the one from strains.
  BlockVector       by_strains = about->apply(found[0].du);
  const BlockVector by_matrix =
    PenaltyMatrix(*about, rows, Symmetry::definite).apply(found[0].du);
  about->condense(by_strains);
  by_strains -= by_matrix;
  BOOST_TEST(by_strains.linfty_norm() < 1e-12 * by_matrix.linfty_norm());
}



BOOST_AUTO_TEST_CASE(a_penalty_beyond_rounding_is_told)
{
  // N t eps / k: some 1e-10 here, and a thousandth with a penalty of 1e12.
  for (const double factor : {1., 1e12})
    {
      TwoCubes scene(press);
      for (GapConstraint &row : scene.contacts[0].rows)
        row.penalty *= factor;
      const auto solver =
        linear_system(Strategy::full, *scene.structure, scene.contacts[0].rows);
      BlockVector u;
      Vector      lambda;
      solver->solve_linear(ActiveConstraints({0, 1, 2}),
                           scene.structure->zero(),
                           Vector(3),
                           u,
                           lambda);
      BOOST_TEST(solver->contact_strategy().warnings().size() ==
                 (factor == 1. ? 0u : 1u));
    }
}



BOOST_AUTO_TEST_CASE(an_open_gap_carries_nothing)
{
  TwoCubes    scene(0.9 * gap);
  const State state = scene.solve(Strategy::condensed);
  BOOST_TEST(state.active.empty());
  BOOST_TEST(state.iterations == 0);
  // The upper cube moves as a whole, so the gap is a tenth everywhere.
  for (const GapConstraint &row : scene.contacts[0].rows)
    BOOST_TEST(std::abs(row.gap(state.u, 1.) - 0.1 * gap) < 1e-12);
  const Checks checks =
    check_state(scene.tangent(state), scene.contacts, 2, state, 1.);
  BOOST_TEST(checks.contacts[0].force.norm() == 0.);
  BOOST_TEST(checks.energy < 1e-20);
}



BOOST_AUTO_TEST_CASE(what_is_no_number_is_refused)
{
  TwoCubes scene(press);
  State    state = scene.solve(Strategy::condensed);
  Checks good = check_state(scene.tangent(state), scene.contacts, 2, state, 1.);
  BOOST_CHECK_NO_THROW(check_solution(state, good, 1.));

  // Each check on its own must be able to refuse.
  const auto refused = [&state](const Checks &checks) {
    BOOST_CHECK_THROW(check_solution(state, checks, 1.), NumericsError);
  };
  for (double Checks::*value :
       {&Checks::force_balance, &Checks::residual, &Checks::energy_balance})
    {
      Checks bad = good;
      bad.*value = 0.01;
      refused(bad);
      bad.*value = std::nan("");
      refused(bad);
    }
  // What a contact does to its two bodies must cancel: rounding here.
  BOOST_TEST(good.contacts[0].imbalance < 1e-9);
  for (const double imbalance : {0.01, std::nan("")})
    {
      Checks bad                = good;
      bad.contacts[0].imbalance = imbalance;
      refused(bad);
    }
  Checks pulls                = good;
  pulls.contacts[0].min_force = -1.;
  refused(pulls);
  Checks lawless                = good;
  lawless.contacts[0].law_error = 0.01 * press;
  refused(lawless);
  Checks turned       = good;
  turned.max_rotation = 1.1;
  refused(turned);

  // A penetrating row that is not active is off the law.
  State forgotten = state;
  forgotten.force.assign(forgotten.force.size(), 0.);
  BOOST_TEST(check_state(scene.tangent(state), scene.contacts, 2, forgotten, 1.)
               .contacts[0]
               .law_error > 1e-3);
}



BOOST_AUTO_TEST_CASE(a_body_that_can_move_is_refused)
{
  const auto section =
    make_section(rectangle(1., 1.), EngineeringConstants::isotropic(E, 0.3), 1);
  Bodies bodies;
  bodies.push_back(
    std::make_unique<Beam>("bar", section, make_axis(1., 1), Placement()));
  const Region  end{0, Region::Kind::surface, "start", {}};
  const Support slides{"slides", {end}, {{std::nullopt, 0., std::nullopt}}};
  // u_y = 0 on a whole end holds y and the rotations about x and z.
  BOOST_CHECK_EXCEPTION(
    Structure(std::move(bodies), {slides}, {}),
    InputError,
    [](const InputError &error) {
      const std::string text = error.what();
      return text.find("Body bar: ") != std::string::npos &&
             text.find("translation along x") != std::string::npos &&
             text.find("translation along z") != std::string::npos &&
             text.find("rotation about y") != std::string::npos &&
             text.find("translation along y") == std::string::npos &&
             text.find("rotation about x") == std::string::npos;
    });
}



BOOST_AUTO_TEST_CASE(a_line_is_prescribed_exactly)
{
  // Along, across and askew, within cells and over their corners: u_z is what
  // was prescribed at every point of the line, not only where rows were taken.
  const std::vector<std::pair<Point<3>, Point<3>>> lines{
    {{0., 1.5, 0.3}, {0.4, 1.5, 0.3}},
    {{0.1, 1.1, 0.3}, {0.3, 2.9, 0.3}},
    {{0., 1.1, 0.}, {0.4, 1.9, 0.3}}};
  for (const auto &[a, b] : lines)
    {
      Bodies bodies;
      bodies.push_back(std::make_unique<Beam>(
        "bar",
        make_section(
          rectangle(0.4, 0.3, {20., -50.}, 2),
          EngineeringConstants{165., 9., 8., 5.6, 5.2, 2.8, .34, .3, .45},
          2),
        make_axis(3., 3),
        Placement()));
      const Support clamp{"clamp",
                          {{0, Region::Kind::surface, "start", {}}},
                          {{0., 0., 0.}}},
        press{"press",
              {{0, Region::Kind::line, "", {a, b}}},
              {{std::nullopt, std::nullopt, -1.}}};
      Structure structure(std::move(bodies), {clamp, press}, {});
      const std::vector<GapConstraint> none;
      const State                      state =
        LinearSystem(linearized(structure), none).solve_free(1.);
      double worst = 0.;
      for (unsigned int i = 0; i <= 100; ++i)
        {
          const Body    &body = *structure.bodies()[0];
          const Location where =
            body.locate({Point<3>(a + i / 100. * (b - a))})[0][0];
          worst =
            std::max(worst,
                     std::abs(
                       body.sample(where, state.u.block(0)).displacement[2] +
                       1.));
        }
      BOOST_TEST(worst < 1e-10);
    }
}



BOOST_AUTO_TEST_CASE(a_turned_scene_gives_turned_results)
{
  // A cantilever under a tip force, along y and along a skew direction: the
  // displacement in the force's direction is the same.
  const auto section = make_section(
    rectangle(0.4, 0.3, {20., -50.}, 1, 1),
    EngineeringConstants{165., 9., 8., 5.6, 5.2, 2.8, .34, .3, .45},
    2);
  std::vector<double> results;
  for (const Placement &placement :
       {Placement(),
        Placement::from_directions({0.2, -0.1, 0.4},
                                   Point<3>(1., 2., 0.5),
                                   Point<3>(-0.3, 0.2, 1.))})
    {
      Bodies bodies;
      bodies.push_back(
        std::make_unique<Beam>("bar", section, make_axis(3., 3), placement));
      const Point<3> tip = placement.to_scene({0.4, 3., 0.3});
      const auto     f   = placement.vector_to_scene(Point<3>(0.3, 0.1, -1.));
      Load           load{"tip", {{0, Region::Kind::point, "", {tip}}}, {}, ""};
      for (unsigned int c = 0; c < 3; ++c)
        load.force[c] = std::to_string(f[c]);
      const Support clamp{"clamp",
                          {{0, Region::Kind::surface, "start", {}}},
                          {{0., 0., 0.}}};
      Structure     structure(std::move(bodies), {clamp}, {load});
      const std::vector<GapConstraint> none;
      const State                      state =
        LinearSystem(linearized(structure), none).solve_free(1.);
      results.push_back(structure.load(1.) * state.u);
    }
  // std::to_string keeps six decimals of the force.
  BOOST_TEST(std::abs(results[0] / results[1] - 1.) < 1e-5);
}

BOOST_AUTO_TEST_SUITE_END()
