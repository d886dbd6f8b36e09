// SPDX-License-Identifier: LGPL-2.1-or-later

// Where stresses have no limit: known from loads, supports and sections, before
// anything is solved.

#include <lamella/adapt/local_interactions.h>
#include <lamella/estimate/comparison.h>
#include <lamella/estimate/error_bar.h>

#include "solved_scene.h"
#include <boost/test/unit_test.hpp>

#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(singularities)
using namespace lamella;

namespace
{
  /// A word of what is said of @p at, empty if nothing is.
  std::string
  said_of(const Simulation &run, const dealii::Point<3> &at)
  {
    const Scene      &scene = run.model().scene();
    const std::string reason =
      singularity_reason(at,
                         0,
                         run.model().structure().bodies(),
                         scene.supports,
                         scene.loads,
                         scene.contacts);
    for (const std::string word : {"clamp", "load", "contact", "corner"})
      if (reason.find(word) != std::string::npos)
        return word;
    BOOST_TEST(reason.empty(), reason);
    return "";
  }



  struct Place
  {
    std::vector<std::string> overrides;
    dealii::Point<3>         at;
    std::string              said;
  };



  void
  check(const std::string &file, const std::vector<Place> &places)
  {
    for (const Place &place : places)
      {
        std::ostream     nowhere(nullptr);
        const Simulation run(read_scene(SceneText::read(
                               LAMELLA_SOURCE_DIR + file, place.overrides)),
                             nowhere);
        std::string      what;
        for (const std::string &override : place.overrides)
          what += override + "; ";
        BOOST_TEST(said_of(run, place.at) == place.said, what << place.at);
      }
  }
} // namespace



BOOST_AUTO_TEST_CASE(at_clamps_loads_and_corners_and_nowhere_else)
{
  const auto clamp = [](const std::string &u) {
    return "Support clamp/u=" + u;
  };
  const std::string plane    = "Supports=clamp, plane",
                    all      = "Support plane/On=beam: body",
                    in_plane = "Support plane/u=0, free, free",
                    far      = "Support plane/On=beam: end";
  const std::vector<std::string> turned{"Body beam/Axis=1, 0, 0",
                                        "Probes=tip",
                                        "Probe tip/At=beam: 10, -0.5, 0.5"};
  check(
    "/prm/cantilever.prm",
    {{{}, {0.5, 0., 1.}, "clamp"},
     {{}, {1., 0., 0.3}, "clamp"},
     {{}, {1., 0., 1.}, "clamp"},
     {{}, {0.5, 0., 0.5}, ""},
     {{}, {0.5, 0.1, 1.}, ""},
     {{}, {0.5, 10., 1.}, ""},
     {{"Theory=solid-1"}, {0.5, 0., 1.}, "clamp"},
     {{"Theory=EBBT"}, {0.5, 0., 1.}, "clamp"},
     {turned, {0., -0.5, 1.}, "clamp"},
     {turned, {0., -0.5, 0.5}, ""},
     // What goes on as its mirror image: held along the axis, or across it.
     {{clamp("free, 0, free"), plane, far, "Support plane/u=0, free, 0"},
      {0.5, 0., 1.},
      ""},
     {{clamp("0, free, 0"), plane, far, "Support plane/u=free, 0, free"},
      {0.5, 0., 1.},
      ""},
     {{clamp("free, 0, 0"), plane, far, "Support plane/u=0, free, free"},
      {0.5, 0., 1.},
      "clamp"},
     {{clamp("free, 0, 0"), plane, far, "Support plane/u=0, free, free"},
      {1., 0., 0.5},
      ""},
     // Plane strain has no sides.
     {{plane, all, in_plane}, {1., 0., 0.5}, ""},
     {{plane, all, in_plane}, {1., 0., 1.}, "clamp"},
     {{plane,
       "Support plane/On=beam: top",
       "Support plane/Normal displacement=0"},
      {0.5, 0., 1.},
      ""},
     {{"Load tip/On=beam: line", "Load tip/At=0, 5, 1; 1, 5, 1"},
      {0.5, 5., 1.},
      "load"},
     {{"Load tip/On=beam: line", "Load tip/At=0, 5, 1; 1, 5, 1"},
      {0.5, 5.01, 1.},
      ""},
     {{"Load tip/On=beam: point", "Load tip/At=0.5, 5, 1"},
      {0.5, 5., 1.},
      "load"},
     {{"Body beam/Section=laminate"}, {0., 5., 1.}, "corner"},
     {{"Body beam/Section=laminate"}, {5., 5., 1.}, ""},
     {{"Body beam/Section=laminate", plane, all, in_plane}, {0., 5., 1.}, ""}});
  check("/tests/scenes/crossed_beams.prm",
        {{{}, {0.25, 3., 0.4}, ""},
         {{}, {0.25, 3.15, 0.4}, "contact"},
         {{}, {0.5, 3., 0.4}, "contact"},
         {{}, {0.25, 3.15, 0.5}, ""}});
  // Sides that are flush end together.
  check("/tests/scenes/blocks_in_contact.prm", {{{}, {2., 2., 1.}, ""}});
  check("/tests/scenes/double_t.prm",
        {{{}, {4.5, 50., 11.}, "corner"}, {{}, {10., 50., 11.}, ""}});
}



BOOST_AUTO_TEST_CASE(such_goals_have_no_bar_and_leave)
{
  // Bars of the two are 50 and 75 % long, and would be as long of finer models.
  const SolvedScene solved(
    "/prm/cantilever.prm",
    {"Theory=LE-3",
     "Probe quarter_left/At=beam: 0.5, 0, 1",
     "Probe quarter_right/At=beam: 0.5, 0, 1",
     "Probe quarter_right/Box=0.5, 0, 0",
     "Probe late_left/At=beam: 0.5, 5, 1",
     "Goals/Quantities=tip: uz | quarter_left: syy | quarter_left: uy | "
     "quarter_right: syy | late_left: syy"});
  ModelCache   cache;
  std::ostream nowhere(nullptr);
  const auto   goals =
    Comparison(solved.run, coarser_model_recipe(solved.run), nowhere, cache)
      .goals();
  const std::vector<bool> limits{true, false, true, true, true};
  for (unsigned int g = 0; g < goals.size(); ++g)
    BOOST_TEST(goals[g].has_limit == limits[g], goals[g].name);
  BOOST_TEST(!goals[1].trusted);
  BOOST_TEST(goals[1].why ==
             "where a clamp meets a free side stresses have no limit. Ask for "
             "it at some distance from there");
}

BOOST_AUTO_TEST_SUITE_END()
