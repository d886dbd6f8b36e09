// SPDX-License-Identifier: LGPL-2.1-or-later

// Results in memory: a scene solved without a folder, every step at hand.

#include <lamella/base/exceptions.h>
#include <lamella/run/run_scene.h>

#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>

BOOST_AUTO_TEST_SUITE(results)

using namespace lamella;

namespace
{
  const std::string file = LAMELLA_SOURCE_DIR "/prm/cantilever.prm";
}



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
                            (step.load_factor.of_scene() * tip) -
                          1.) < 1e-10);
      BOOST_TEST(std::abs(step.checks.reactions[0].force[2] +
                          0.1 * step.load_factor.of_scene()) < 1e-9);
      BOOST_TEST(std::abs(step.checks.reactions[0].moment[0] +
                          step.load_factor.of_scene()) < 1e-8);
    }
}



BOOST_AUTO_TEST_CASE(a_warning_is_said_once_for_all_steps)
{
  Results results;
  results.load_steps = 5;
  results.notes      = {"a note"};
  results.endnotes   = {"an end", "a note"};
  for (unsigned int step = 1; step <= 5; ++step)
    {
      results.steps.emplace_back();
      results.steps.back().step        = step;
      results.steps.back().load_factor = step == 5 ? 0. : 1. * step;
    }
  for (const unsigned int step : {1, 2, 4})
    results.steps[step - 1].warnings.push_back("contact c-1 is the same");
  for (const unsigned int step : {2, 3, 4, 5})
    results.steps[step - 1].warnings.push_back(
      "gaps of 1e-3 and -" + std::to_string(step) + ".5 in contact c-1");
  // Of one kind, but two things to say.
  results.steps[2].warnings.push_back("probe p is off by 7 %");
  results.steps[2].warnings.push_back("probe p is off by 8 %");
  const std::vector<std::string> expected{
    "a note",
    "load steps 1-2, 4: contact c-1 is the same",
    "load steps 2-5 (numbers of step 4): gaps of 1e-3 and -4.5 in contact c-1",
    "load step 3: probe p is off by 7 %",
    "load step 3: probe p is off by 8 %",
    "an end"};
  BOOST_TEST(results.all_warnings() == expected,
             boost::test_tools::per_element());
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



BOOST_AUTO_TEST_CASE(fields_of_nodes_add_up)
{
  // Of a beam along x, whose pieces are LE-2 and SV: 13 nodes on 4 B4, the
  // fields of a 2 x 2 section in LE-3 (its space) to the one side, 12 on the
  // other.
  std::ostream nowhere(nullptr);
  const Scene  scene =
    read_scene(SceneText::read(file,
                               {"Body beam/Axis=1, 0, 0",
                                "Body beam/Kinematics/Theories=LE-3, SV",
                                "Body beam/Kinematics/Theory breaks=5",
                                "Probes="}));
  Simulation     simulation(scene, nowhere);
  const Results &results = simulation.solve();
  const auto     folder =
    std::filesystem::temp_directory_path() / "lamella_fields_of_nodes";
  write_run(simulation, folder.string());
  std::ifstream table(folder / "fields.csv");
  std::string   line;
  std::getline(table, line);
  BOOST_TEST(line == "body,node,s,x,y,z,fields");
  unsigned int nodes = 0, fields = 0;
  while (std::getline(table, line))
    {
      std::istringstream cells(line);
      std::string        body, cell;
      std::getline(cells, body, ',');
      std::vector<double> numbers;
      while (std::getline(cells, cell, ','))
        numbers.push_back(std::stod(cell));
      BOOST_TEST(body == "beam");
      BOOST_TEST(numbers[0] == ++nodes);
      BOOST_TEST(std::abs(numbers[2] - numbers[1]) < 1e-12);
      BOOST_TEST(numbers[5] == (numbers[1] < 5. + 1e-9 ? 147. : 12.));
      fields += numbers[5];
    }
  BOOST_TEST(nodes == 13u);
  BOOST_TEST(fields == results.n_dofs());
  std::filesystem::remove_all(folder);
}



BOOST_AUTO_TEST_SUITE_END()
