// SPDX-License-Identifier: LGPL-2.1-or-later

// A clamped-clamped [0/90/0] strip under a central line load, from slender to a
// hair. As L/h grows, shear vanishes and the deflection's ratio to beam theory,
// F L^3 / (192 EI) with EI of classical lamination theory, tends to a constant
// near one: 4 B4 hold the cubic between clamp and load exactly, and what is
// left is how the section's edges depart from lamination theory. Any drift is
// lost digits. See doc/theory/stable-basis.md.

#include "fixtures.h"

#include <lamella/material/material.h>
#include <lamella/solve/checks.h>
#include <lamella/solve/linear_system.h>

#include <boost/test/unit_test.hpp>

#include <iomanip>

BOOST_AUTO_TEST_SUITE(slender)

using namespace lamella;
using dealii::Point;

namespace
{
  constexpr double width = 0.01, height = 0.003;

  struct Result
  {
    double ratio = 0., first_correction = 0.;
  };

  /// Of the strip of length @p slenderness * height, with @p refine or without
  /// the strain-first refinement.
  Result
  deflection_ratio(const double slenderness, const bool refine)
  {
    const Laminate laminate = rectangle(width, height, {0., 90., 0.}, 2);
    const auto     material = library_material("IM7-8552", Units());
    const double   length   = slenderness * height;
    Bodies         bodies;
    bodies.push_back(std::make_unique<Beam>("strip",
                                            make_section(laminate, material, 2),
                                            make_axis(length, 4),
                                            Placement()));
    const Support clamp{"clamps",
                        {{0, Region::Kind::surface, "ends", {}}},
                        {{0., 0., 0.}}};
    // A line across the mid-plane, 1 N in all.
    const Point<3> a(0., 0.5 * length, 0.5 * height),
      b(width, 0.5 * length, 0.5 * height);
    const Load load{"center",
                    {{0, Region::Kind::line, "", {a, b}}},
                    {{"0", "0", "-100"}},
                    ""};
    Structure  structure(std::move(bodies), {clamp}, {load});
    const std::vector<GapConstraint> none;
    NonlinearParameters              parameters;
    parameters.max_refinements = refine ? 6 : 0;
    LinearSystem system(linearized(structure), none, parameters);

    Result result;
    State  state;
    if (refine)
      {
        state                   = system.solve_free(1.);
        result.first_correction = state.free_corrections.front();
        // A run accepts the scene (at L/h = 1e6 with a warning on reactions).
        check_solution(state,
                       check_state(system.tangent(), {}, 1, state, 1.),
                       1e9);
      }
    else
      {
        const Vector dummy;
        Vector       nothing;
        system.solve_linear({}, structure.load(1.), dummy, state.u, nothing);
      }
    const Body    &body = *structure.bodies()[0];
    const Point<3> middle(0.5 * width, 0.5 * length, 0.5 * height);
    const auto     sample =
      body.sample(body.locate({middle})[0][0], state.u.block(0));
    const double EI =
      laminate_stiffness(laminate.plies({{"material", material}}), width).EI;
    result.ratio =
      -sample.displacement[2] / (std::pow(length, 3) / (192. * EI));
    return result;
  }
} // namespace

BOOST_AUTO_TEST_CASE(refined_to_a_hair)
{
  // Shear adds about 200 (h/L)^2 (from 48 EI / (k GA L^2)): 2e-6 at 1e4, 2e-8
  // at 1e5, nothing at 1e6.
  const double slender = deflection_ratio(1e5, true).ratio;
  const double hair    = deflection_ratio(1e6, true).ratio;
  BOOST_TEST_MESSAGE("L/h = 1e5 and 1e6: ratios " << slender << ", off by "
                                                  << hair / slender - 1.);
  BOOST_TEST(std::abs(hair / slender - 1.) < 1e-7);
  // Lamination theory neglects the free edges.
  BOOST_TEST(std::abs(slender - 1.) < 0.02);
  const double stubbier = deflection_ratio(1e4, true).ratio;
  BOOST_TEST(stubbier / slender - 1. > 1e-6);
  BOOST_TEST(stubbier / slender - 1. < 3e-6);
}



BOOST_AUTO_TEST_CASE(the_first_correction_tells_the_digits_that_were_lost)
{
  // Without refinement the result is off by about what the first correction of
  // the refined run reports: the detector of lost digits. The table of
  // doc/theory/stable-basis.md is what this prints with --log_level=message.
  BOOST_TEST_MESSAGE("L/h   refined ratio   off without refinement   detector");
  for (const double slenderness : {1e2, 1e3, 1e4, 1e5, 1e6})
    {
      const Result refined = deflection_ratio(slenderness, true),
                   plain   = deflection_ratio(slenderness, false);
      const double off     = std::abs(plain.ratio / refined.ratio - 1.);
      BOOST_TEST_MESSAGE(slenderness << "   " << std::setprecision(9)
                                     << refined.ratio << std::setprecision(2)
                                     << "   " << off << "   "
                                     << refined.first_correction);
      if (slenderness > 1e5)
        BOOST_TEST(off > 1e-7);
      BOOST_TEST(refined.first_correction < 30. * off + 1e-12);
      BOOST_TEST(refined.first_correction > 0.03 * off);
    }
}

BOOST_AUTO_TEST_SUITE_END()
