// SPDX-License-Identifier: LGPL-2.1-or-later

// What a goal near zero is small against: a soft core bears next to nothing
// beside its stiff faces, and is judged by what it bears itself.

#include <lamella/estimate/error_bar.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <ostream>

BOOST_AUTO_TEST_SUITE(goal_scales)
using namespace lamella;

namespace
{
  /// A long sandwich, clamped at its start and loaded at its end, and a block
  /// of another material that nothing loads.
  struct Sandwich
  {
    explicit Sandwich(const std::vector<std::string> &more = {})
      : simulation(read_scene(scene_with(more)), nowhere)
    {
      simulation.solve();
    }

    static SceneText
    scene_with(const std::vector<std::string> &more)
    {
      std::vector<std::string> overrides{
        "Bodies=beam, idle",
        "Supports=clamp, hold",
        "Body beam/Section=sandwich",
        "Body beam/Length=1000",
        "Load tip/Force=0, 0, 0.001",
        "Body idle/Section=square",
        "Body idle/Length=1",
        "Body idle/Origin=0, 0, 50",
        "Support hold/On=idle: start",
        "Probes=face, core, between, box, idle",
        "Probe face/At=beam: 2.5, 100, 0",
        "Probe core/At=beam: 2.5, 500, 0.5",
        "Probe between/At=beam: 2.5, 500, 0.1",
        "Probe box/At=beam: 2.5, 500, 0.15",
        "Probe box/Box=0, 0, 0.2",
        "Probe idle/At=idle: 0.5, 0.5, 50.5",
        "Goals/Quantities=core: syz | core: sxy | face: gxy | between/1: sxy | "
        "between/2: sxy | box: sxy | idle: syy | core: ux | face: syy"};
      overrides.insert(overrides.end(), more.begin(), more.end());
      return SceneText::read(LAMELLA_SOURCE_DIR "/prm/cantilever.prm",
                             overrides);
    }

    std::ostream nowhere{nullptr};
    Simulation   simulation;
  };



  /// The largest of the six @p part of the sample in @p ply of the probe.
  double
  largest(const Results     &results,
          const std::string &probe,
          const unsigned int ply,
          Voigt FieldSample::*const part)
  {
    double all = 0.;
    for (unsigned int c = 0; c < 6; ++c)
      all =
        std::max(all, std::abs((results.probe(probe, ply).sample.*part)[c]));
    return all;
  }
} // namespace



BOOST_AUTO_TEST_CASE(a_core_is_judged_by_itself)
{
  const Sandwich sandwich;
  const Results &results = sandwich.simulation.results();
  const RunGoals goals(sandwich.simulation);
  const auto    &all     = goals.quantities();
  const auto     stress  = &FieldSample::stress;
  const double   of_face = largest(results, "face", 1, stress);
  const double   of_core = std::max(largest(results, "core", 2, stress),
                                  largest(results, "between", 2, stress));
  // The trap: beside the face the core's shear stress is nearly nothing.
  BOOST_TEST(goals.numbers().largest_of_kind(all[0]) == of_face);
  BOOST_TEST(std::abs(goals.numbers().value(all[0])) < 1e-3 * of_face);
  BOOST_TEST(std::abs(goals.numbers().value(all[0])) > 0.01 * of_core);
  BOOST_TEST(goals.scale_of(all[0]) == std::abs(goals.numbers().value(all[0])));
  // What is zero is small against the same material's, shear or not, at any
  // place; strains likewise.
  BOOST_TEST(goals.scale_of(all[1]) == of_core);
  BOOST_TEST(goals.scale_of(all[2]) ==
             std::max(largest(results, "face", 1, &FieldSample::strain),
                      largest(results, "between", 1, &FieldSample::strain)));
  // Between two plies by the one that is named.
  BOOST_TEST(goals.scale_of(all[3]) == of_face);
  BOOST_TEST(goals.scale_of(all[4]) == of_core);
  // A box over both is small against its own stresses.
  BOOST_TEST(goals.scale_of(all[5]) ==
             largest(results, "box", 0, &FieldSample::stress));
  // What bears nothing is no scale, nor are displacements told by materials.
  BOOST_TEST(goals.scale_of(all[6]) == of_face);
  BOOST_TEST(goals.scale_of(all[7]) == goals.numbers().largest_of_kind(all[7]));
  BOOST_TEST(goals.without_error_bar(0).unit == "MPa");
  // Arithmetic leaves the same of all stresses.
  BOOST_TEST(goals.rounding_of(all[0]) == goals.rounding_of(all[8]));
}



BOOST_AUTO_TEST_CASE(what_a_goal_may_be_off_by)
{
  const Sandwich sandwich(
    {"Goals/Quantities=core: syz | core: sxy", "Goals/Tolerance=1, 0.02 MPa"});
  const RunGoals   goals(sandwich.simulation);
  const GoalResult share    = goals.without_error_bar(0),
                   absolute = goals.without_error_bar(1);
  BOOST_TEST(share.allowed_error() == 0.01 * std::abs(share.value));
  BOOST_TEST(!share.is_near_zero());
  BOOST_TEST(absolute.allowed_error() == 0.02);
  BOOST_TEST(absolute.is_near_zero());
  GoalResult met = absolute;
  met.trusted    = true;
  met.bar        = 0.019;
  BOOST_TEST(met.met());
  met.bar = 0.021;
  BOOST_TEST(!met.met());
}

BOOST_AUTO_TEST_SUITE_END()
