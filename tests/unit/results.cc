// SPDX-License-Identifier: LGPL-2.1-or-later

// Results in memory: a scene solved without a folder, every step at hand.

#include <lamella/base/exceptions.h>
#include <lamella/run/simulation.h>

#include <boost/test/unit_test.hpp>

#include <ostream>

using namespace lamella;

namespace
{
  const std::string file = LAMELLA_SOURCE_DIR "/prm/cantilever.prm";
}



BOOST_AUTO_TEST_SUITE(results)



BOOST_AUTO_TEST_CASE(every_step_is_kept)
{
  std::ostream nowhere(nullptr);
  const Scene  scene =
    read_scene(SceneText::read(file, {"Load factors=0.5, 1, 2"}));
  Simulation     simulation(scene, nowhere);
  const Results &results = simulation.solve();
  BOOST_TEST(results.converged);
  BOOST_TEST(results.steps.size() == 3u);
  BOOST_TEST(results.n_dofs() == results.bodies[0].dofs);
  const double tip = results.steps[1].probes[0].front().sample.displacement[2];
  for (const StepResults &step : results.steps)
    {
      // A linear scene without contact: all of it in proportion.
      BOOST_TEST(step.state.u.size() == results.n_dofs());
      BOOST_TEST(std::abs(step.probes[0].front().sample.displacement[2] /
                            (step.load_factor * tip) -
                          1.) < 1e-10);
      BOOST_TEST(std::abs(step.checks.reactions[0].force[2] +
                          0.1 * step.load_factor) < 1e-9);
      BOOST_TEST(
        std::abs(step.checks.reactions[0].moment[0] + step.load_factor) < 1e-8);
    }
}



BOOST_AUTO_TEST_CASE(an_observer_takes_what_is_dropped)
{
  std::ostream nowhere(nullptr);
  const Scene  scene =
    read_scene(SceneText::read(file, {"Load factors=0.5, 1, 2"}));
  Simulation          simulation(scene, nowhere);
  std::vector<double> tips;
  simulation.solve([&tips](const Results &results) {
    BOOST_TEST(results.steps.size() == tips.size() + 1);
    BOOST_TEST(results.seconds.count("total") == 1u);
    tips.push_back(results.probe("tip").sample.displacement[2]);
  });
  BOOST_TEST(tips.size() == 3u);
  BOOST_TEST(std::abs(tips[2] / tips[0] - 4.) < 1e-9);
  BOOST_TEST(simulation.results().steps[0].probes.empty());
  BOOST_TEST(simulation.results().steps[0].state.u.size() == 0u);
  BOOST_TEST(!simulation.results().steps[2].probes.empty());
}



BOOST_AUTO_TEST_CASE(names_that_are_not_there)
{
  std::ostream nowhere(nullptr);
  const Scene  scene = read_scene(SceneText::read(file, {}));
  Simulation   simulation(scene, nowhere);
  BOOST_CHECK_THROW(simulation.results().last(), InputError);
  const Results &results = simulation.solve();
  BOOST_TEST(results.support("clamp").force[2] < 0.);
  BOOST_TEST(results.probe("tip", 1).ply == 0u);
  BOOST_CHECK_THROW(results.probe("top"), InputError);
  BOOST_CHECK_THROW(results.probe("tip", 2), InputError);
  BOOST_CHECK_THROW(results.support("tip"), InputError);
  BOOST_CHECK_THROW(results.contact("clamp"), InputError);
}



BOOST_AUTO_TEST_SUITE_END()
