// SPDX-License-Identifier: LGPL-2.1-or-later

// What the contact loop must hold in every load step and hard case: the
// Kuhn-Tucker conditions for `exact` and `augmented lagrangian`, in a bounded
// number of iterations, by both strategies.

#include "contact_scene.h"

#include <lamella/base/exceptions.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(enforcement)

using namespace lamella;
using dealii::Point;

namespace
{
  constexpr double length = 4., width = 0.4, height = 0.2, E = 1000.;
  constexpr double load = 0.02;

  std::unique_ptr<Body>
  make_beam(const char *const  name,
            const char *const  kinematics,
            const unsigned int elements,
            const double       modulus,
            const double       at_height,
            const double       nu = 0.3)
  {
    Placement placement;
    placement.origin = Point<3>(0., 0., at_height);
    return std::make_unique<Beam>(
      name,
      make_section(make_section_mesh(rectangle(width, height),
                                     {{"material",
                                       EngineeringConstants::isotropic(modulus,
                                                                       nu)}}),
                   Theory::parse({"Theory", kinematics})),
      make_axis(length, elements),
      placement);
  }



  /// How a scene is to be solved.
  struct Method
  {
    Enforcement enforcement = Enforcement::exact;
    Strategy    strategy    = Strategy::condensed;
  };

  const std::vector<Method> without_penetration{
    {Enforcement::exact, Strategy::condensed},
    {Enforcement::augmented_lagrangian, Strategy::condensed},
    {Enforcement::exact, Strategy::full},
    {Enforcement::augmented_lagrangian, Strategy::full}};



  /// Two beams clamped at both ends, the upper one @p gap above the lower one
  /// and @p ratio times as stiff, pressed down on a half of its length so that
  /// contact begins off the middle; rows in three lines along them.
  ContactScene
  stacked_beams(const Method &method,
                const double  gap,
                const double  ratio      = 1.,
                const char   *kinematics = "LE-2")
  {
    constexpr unsigned int elements = 8, along = 3 * elements;
    Bodies                 bodies;
    bodies.push_back(make_beam("lower", kinematics, elements, E, 0.));
    bodies.push_back(
      make_beam("upper", kinematics, elements, ratio * E, height + gap));
    ContactScene scene;
    for (unsigned int k = 0; k <= along; ++k)
      for (const double x : {0., 0.5, 1.})
        {
          const double  y = std::min(k * length / along, length);
          GapConstraint row =
            above_floor(bodies,
                        {x * width, y, height + gap},
                        gap,
                        method.enforcement,
                        1000. * E * width / 3. * length / along / height,
                        1);
          const GapConstraint below =
            above_floor(bodies, {x * width, y, height}, 0., {}, 0., 0);
          row.parts.push_back({0, {}});
          row.parts.back().row.add(below.parts[0].row, -1.);
          scene.rows.push_back(row);
        }
    const std::vector<Support> clamps{
      {"lower", {{0, Region::Kind::surface, "ends", {}}}, {{0., 0., 0.}}},
      {"upper", {{1, Region::Kind::surface, "ends", {}}}, {{0., 0., 0.}}}};
    const Load press{
      "press",
      {{1, Region::Kind::surface, "top", {}}},
      {{"0", "0", "if(y < 2.5, " + digits(-load * ratio) + ", 0)"}},
      ""};
    scene.structure = std::make_unique<Structure>(std::move(bodies),
                                                  clamps,
                                                  std::vector{press});
    scene.prepare(method.strategy);
    return scene;
  }
} // namespace

BOOST_AUTO_TEST_CASE(a_cantilever_on_a_stop)
{
  // delta_free = F L^3 / (3 E I), R = 3 E I / L^3 (delta_free - g).
  const double I = width * height * height * height / 12., F = 0.1,
               stiffness = 3. * E * I / std::pow(length, 3),
               g         = 0.4 * F / stiffness;
  for (const Method &method : without_penetration)
    {
      Bodies bodies;
      bodies.push_back(make_beam("beam", "EBBT", 4, E, 0., 0.));
      ContactScene scene;
      scene.rows.push_back(above_floor(bodies,
                                       {0.5 * width, length, 0.},
                                       g,
                                       method.enforcement,
                                       1000. * stiffness));
      Load tip{"tip",
               {{0,
                 Region::Kind::point,
                 "",
                 {Point<3>(0.5 * width, length, 0.5 * height)}}},
               {{"0", "0", digits(-F)}},
               ""};
      scene.structure = std::make_unique<Structure>(std::move(bodies),
                                                    std::vector{clamp("start")},
                                                    std::vector{tip});
      scene.prepare(method.strategy);
      const State state = scene.solve();
      BOOST_TEST(std::abs(state.force[0] / (F - stiffness * g) - 1.) < 1e-8);
      BOOST_TEST(scene.violation(state) < 1e-12);
    }
}



BOOST_AUTO_TEST_CASE(opening_closing_and_opening_again)
{
  for (const Method &method : without_penetration)
    {
      const ContactScene scene = stacked_beams(method, 0.002);
      State              state, first;
      for (const double factor : {0.02, 0.5, 1., 0.5, 0.01, -1., 1., 0.})
        {
          state = scene.solve(factor, state);
          BOOST_TEST_MESSAGE("factor " << factor << ": " << state.active.size()
                                       << " active, " << state.iterations
                                       << " iterations, KKT "
                                       << scene.violation(state, factor));
          if (factor == 0.)
            BOOST_TEST(state.u.linfty_norm() == 0.);
          else
            BOOST_TEST(scene.violation(state, factor) < 1e-9);
          BOOST_TEST(state.active.empty() == (factor < 0.1));
          // The same state whatever went before.
          if (factor == 1. && first.force.empty())
            first = state;
          else if (factor == 1.)
            for (unsigned int r = 0; r < scene.rows.size(); ++r)
              BOOST_TEST(std::abs(state.force[r] - first.force[r]) <
                         1e-6 * sum(first.force));
        }
    }
}



BOOST_AUTO_TEST_CASE(several_enforcements_in_one_scene)
{
  // Lines of rows side by side, each enforced in its own way, by both
  // strategies.
  std::vector<State> states;
  for (const Strategy strategy : {Strategy::condensed, Strategy::full})
    {
      ContactScene scene =
        stacked_beams({Enforcement::penalty, strategy}, 0.01);
      for (unsigned int r = 0; r < scene.rows.size(); ++r)
        scene.rows[r].enforcement =
          r % 3 == 0 ? Enforcement::penalty :
          r % 3 == 1 ? Enforcement::augmented_lagrangian :
                       Enforcement::exact;
      scene.prepare(strategy);
      states.push_back(scene.solve());
      double off = 0.;
      for (unsigned int r = 0; r < scene.rows.size(); ++r)
        if (states.back().force[r] != 0.)
          off = std::max(off,
                         std::abs(scene.rows[r].gap(states.back().u, 1.) +
                                  law_compliance(scene.rows[r]) *
                                    states.back().force[r]));
      BOOST_TEST(off < 1e-9 * states.back().u.linfty_norm());
    }
  BOOST_TEST(!states[0].active.empty());
  BOOST_TEST(states[0].active == states[1].active);
  BOOST_TEST(std::abs(sum(states[0].force) / sum(states[1].force) - 1.) < 1e-8);
}



BOOST_AUTO_TEST_CASE(two_bodies_in_hard_cases)
{
  // Gaps of zero and of next to nothing, stiffness ratios of a million.
  struct Case
  {
    const char *what;
    double      gap, ratio;
  };
  for (const Case &c : {Case{"zero gap", 0., 1.},
                        Case{"gap 1e-12 of the size", 1e-12 * length, 1.},
                        Case{"upper 1e6 times stiffer", 0.01, 1e6},
                        Case{"lower 1e6 times stiffer", 0.01, 1e-6},
                        Case{"zero gap, upper 1e6 times stiffer", 0., 1e6},
                        Case{"zero gap, lower 1e6 times stiffer", 0., 1e-6}})
    for (const Method &method :
         {Method{Enforcement::exact, Strategy::condensed},
          Method{Enforcement::penalty, Strategy::condensed},
          Method{Enforcement::penalty, Strategy::full}})
      {
        const ContactScene scene = stacked_beams(method, c.gap, c.ratio);
        const State        state = scene.solve();
        BOOST_TEST_MESSAGE(
          c.what << ", "
                 << (method.enforcement == Enforcement::exact ? "exact" :
                                                                "penalty")
                 << (method.strategy == Strategy::full ? ", full: " :
                                                         ", condensed: ")
                 << state.iterations << " iterations, " << state.active.size()
                 << " of " << scene.rows.size() << " active, KKT "
                 << scene.violation(state));
        BOOST_TEST(state.iterations <= 30);
        if (method.enforcement == Enforcement::exact)
          BOOST_TEST(scene.violation(state) < 1e-9);
      }
}



BOOST_AUTO_TEST_CASE(many_rows)
{
  // A cantilever over a floor that rises towards one side: a third of 10^4 rows
  // penetrate without contact, one corner touches. (Thousands of rows that all
  // close: scene/all_close.)
  const unsigned int across = 50, along = 200;
  for (const Enforcement enforcement :
       {Enforcement::exact, Enforcement::penalty})
    {
      Bodies bodies;
      bodies.push_back(make_beam("beam", "TBT", 6, E, 0., 0.));
      ContactScene scene;
      for (unsigned int i = 0; i < across; ++i)
        for (unsigned int j = 0; j < along; ++j)
          {
            const double x = (i + 0.5) / across, y = (j + 0.5) / along;
            scene.rows.push_back(above_floor(bodies,
                                             {x * width, y * length, 0.},
                                             0.1 * (1. - 0.01 * x),
                                             enforcement,
                                             1000. * E * width * length /
                                               across / along / height));
          }
      scene.structure = std::make_unique<Structure>(
        std::move(bodies),
        std::vector{clamp("start")},
        std::vector{traction("top", "0", "0", digits(-load))});
      scene.prepare(Strategy::condensed);
      const State state = scene.solve();
      BOOST_TEST_MESSAGE(scene.rows.size()
                         << " rows: " << state.iterations << " iterations, "
                         << state.active.size() << " active, KKT "
                         << scene.violation(state));
      BOOST_TEST(state.iterations <= 30);
      BOOST_TEST(state.active.size() < 10);
      if (enforcement == Enforcement::exact)
        BOOST_TEST(scene.violation(state) < 1e-9);
    }
}



BOOST_AUTO_TEST_CASE(what_does_not_settle_is_named)
{
  const ContactScene scene =
    stacked_beams({Enforcement::penalty, Strategy::condensed}, 0., 1.);
  NonlinearParameters parameters;
  parameters.max_iterations = 1;
  LinearSystem    system(linearized(*scene.structure), scene.rows, parameters);
  NonlinearSolver newton(system, parameters);
  newton.describe = [](const unsigned int row) {
    return "point " + std::to_string(row);
  };
  std::vector<std::string> lines;
  newton.progress = [&lines](const std::string &line) {
    lines.push_back(line);
  };
  BOOST_CHECK_EXCEPTION(newton.solve(1.),
                        NumericsError,
                        [](const NumericsError &error) {
                          const std::string text = error.what();
                          return text.find("inactive (point ") !=
                                   std::string::npos &&
                                 text.find("Try ") != std::string::npos;
                        });
  BOOST_TEST(lines.size() == 1);
  BOOST_TEST(lines[0].find("gaps off by up to") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
