// SPDX-License-Identifier: LGPL-2.1-or-later

// Where errors of goals come from: the shares of elements, contact and
// remainder against the change of the goal itself.

#include <lamella/estimate/enrichment.h>
#include <lamella/estimate/local_errors.h>

#include "quantities.h"
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numeric>
#include <ostream>

BOOST_AUTO_TEST_SUITE(local_errors)

using namespace lamella;

namespace
{
  /// A scene and the same with all elements along the axis halved, both solved.
  struct TwoModels
  {
    TwoModels(const std::string &file, std::vector<std::string> overrides)
      : scene(read_scene(
          SceneText::read(LAMELLA_SOURCE_DIR + file, std::move(overrides))))
      , nowhere(nullptr)
      , coarse(scene, nowhere)
      , fine(enriched(coarse.model().scene(),
                      Source::axis,
                      sizes_of(coarse.model())),
             nowhere)
    {
      coarse.solve();
      fine.solve();
      BOOST_REQUIRE(Localization::is_possible(coarse, fine));
    }

    double
    change(const NamedQuantity &goal) const
    {
      return ResultNumbers(fine.results()).value(goal) -
             ResultNumbers(coarse.results()).value(goal);
    }

    Scene        scene;
    std::ostream nowhere;
    Simulation   coarse, fine;
  };



  double
  sum_of(const LocalErrors &errors)
  {
    return std::accumulate(errors.elements.begin(),
                           errors.elements.end(),
                           0.,
                           [](const double sum, const ElementError &element) {
                             return sum + element.error;
                           });
  }



  const NamedQuantity
    probe_uz  = quantity_of(NamedQuantity::ObjectKind::probe, "middle", "uz"),
    probe_syz = quantity_of(NamedQuantity::ObjectKind::probe, "one", "syz"),
    probe_s11 = quantity_of(NamedQuantity::ObjectKind::probe, "two", "s11"),
    reaction  = quantity_of(NamedQuantity::ObjectKind::support, "clamps", "fz");
} // namespace

BOOST_AUTO_TEST_CASE(elements_sum_to_the_change_where_spaces_are_nested)
{
  // Nothing is left over and nothing is contact's: the residual is orthogonal
  // to the coarser space.
  for (const char *const theory : {"LE-2", "TE-3", "SV", "TBT"})
    {
      const TwoModels    models("/tests/scenes/clamped_laminate.prm",
                             {std::string("Theory=") + theory,
                                 "Body beam/Kinematics/Axis elements=3, 2",
                                 "Body beam/Kinematics/Axis breaks=9",
                                 "Load patch/Pressure=1 + x + 0.1 * y"});
      const Localization localization(models.coarse, models.fine);
      for (const NamedQuantity &goal : {probe_uz, probe_syz, probe_s11})
        {
          const double change = models.change(goal);
          const auto   errors = localization.errors(goal, change);
          BOOST_REQUIRE(errors.has_value());
          BOOST_TEST(errors->elements.size() == 5u);
          const double value =
            std::abs(ResultNumbers(models.fine.results()).value(goal));
          BOOST_TEST_CONTEXT(theory << " " << goal.label())
          {
            BOOST_TEST(std::abs(sum_of(*errors) - change) < 1e-10 * value);
            BOOST_TEST(std::abs(errors->remainder) < 1e-10 * value);
            BOOST_TEST(std::abs(errors->contact) < 1e-10 * value);
          }
        }
    }
}



BOOST_AUTO_TEST_CASE(reactions_have_a_dual)
{
  // Of two clamps what one of them carries depends on the mesh.
  const TwoModels    models("/tests/scenes/clamped_laminate.prm",
                         {"Theory=LE-2",
                             "Supports=clamps, other",
                             "Support other/On=beam: end",
                             "Support clamps/On=beam: start",
                             "Body beam/Kinematics/Axis elements=2, 1",
                             "Body beam/Kinematics/Axis breaks=13",
                             "Load patch/Pressure=if(y < 13, 1 + x, 0)"});
  const Localization localization(models.coarse, models.fine);
  const double       change = models.change(reaction);
  const auto         errors = localization.errors(reaction, change);
  BOOST_REQUIRE(errors.has_value());
  BOOST_TEST(std::abs(change) > 1e-4);
  BOOST_TEST(std::abs(sum_of(*errors) - change) < 1e-9);
}



BOOST_AUTO_TEST_CASE(contact_is_told_apart)
{
  // The rows of the finer model are others than those of the coarser one: what
  // they find is contact's, and nothing is left over.
  for (const char *const enforcement : {"exact", "penalty"})
    {
      const TwoModels models(
        "/prm/sandwich.prm",
        {"Theory=LE-1",
         "Section sandwich/Cells per ply=1",
         "Section sandwich/Cells across=1",
         "Body beam/Kinematics/Axis elements=2, 1, 2, 1, 2",
         std::string("Contact indentation/Enforcement=") + enforcement});
      const Localization localization(models.coarse, models.fine);
      for (const NamedQuantity &goal :
           {quantity_of(NamedQuantity::ObjectKind::contact,
                        "indentation",
                        "fz"),
            quantity_of(NamedQuantity::ObjectKind::support, "clamps", "fz"),
            quantity_of(NamedQuantity::ObjectKind::probe, "quarter", "uy"),
            quantity_of(NamedQuantity::ObjectKind::probe, "core", "syz")})
        {
          const double change = models.change(goal);
          const auto   errors = localization.errors(goal, change);
          BOOST_REQUIRE(errors.has_value());
          BOOST_TEST_CONTEXT(enforcement << " " << goal.label())
          {
            BOOST_TEST(std::abs(sum_of(*errors) + errors->contact - change) <
                       1e-7 * std::abs(change));
          }
        }
    }
}



BOOST_AUTO_TEST_CASE(elements_that_matter_are_marked)
{
  Scene           scene;
  BodyDescription body;
  body.axis.length   = 4.;
  body.axis.elements = {2, 1};
  body.axis.breaks   = {2.};
  scene.bodies       = {body};
  GoalResult goal;
  goal.value = goal.scale = 1.;
  goal.tolerance          = Tolerance{1e-2};
  goal.bar                = 2e-2;
  goal.trusted            = true;
  goal.local              = LocalErrors{
    {{0, 0., 1., 8e-3, 10}, {0, 1., 2., -1e-3, 10}, {0, 2., 4., 1e-3, 40}}};
  // Eight of ten are done by the first.
  const auto marked = marked_elements(scene, {goal}, 0.5, 0.65);
  BOOST_REQUIRE(marked.has_value());
  BOOST_TEST(marked->size() == 1u);
  // More have to go where a tenth of the tolerance may be left.
  const auto more = marked_elements(scene, {goal}, 0.15, 0.65);
  BOOST_TEST(more->size() == 2u);
  const AxisMesh axis = bisected(scene, *more).bodies[0].axis;
  BOOST_TEST(axis.breaks == std::vector<double>({2.}),
             boost::test_tools::per_element());
  BOOST_TEST(axis.elements == std::vector<unsigned int>({4, 1}),
             boost::test_tools::per_element());
  // One of two equal elements.
  BOOST_TEST(element_lengths(bisected(scene, *marked).bodies[0].axis) ==
               std::vector<double>({0.5, 0.5, 1., 2.}),
             boost::test_tools::per_element());

  goal.local = {};
  BOOST_TEST(!marked_elements(scene, {goal}, 0.1, 0.65).has_value());
}



namespace
{
  /// The DoFs that @p goal takes to be within @p tolerance of @p truth where
  /// each pass bisects the elements that have seven tenths of the sum of
  /// |errors| per DoF, or all of them.
  unsigned int
  dofs_to_reach(const NamedQuantity &goal,
                const double         truth,
                const double         tolerance,
                const bool           by_goal)
  {
    Scene scene = read_scene(
      SceneText::read(LAMELLA_SOURCE_DIR "/tests/scenes/clamped_laminate.prm",
                      {"Theory=LE-1",
                       "Body beam/Kinematics/Axis elements=2, 2",
                       "Body beam/Kinematics/Axis breaks=9",
                       "Section laminate/Cells across=2",
                       "Load patch/Pressure=if(y > 9, 1 + x, 0)"}));
    std::ostream nowhere(nullptr);
    for (unsigned int pass = 0; pass < 12; ++pass)
      {
        Simulation   coarse(scene, nowhere);
        const double value = ResultNumbers(coarse.solve()).value(goal);
        if (std::abs(value - truth) <= tolerance * std::abs(truth))
          return coarse.results().bodies.front().dofs;
        const Scene halved = enriched(coarse.model().scene(),
                                      Source::axis,
                                      sizes_of(coarse.model()));
        if (!by_goal)
          {
            scene = halved;
            continue;
          }
        Simulation fine(halved, nowhere);
        fine.solve();
        GoalResult result;
        result.local     = Localization(coarse, fine).errors(goal, 0.);
        result.tolerance = Tolerance{1.};
        result.scale     = 1e30;
        scene            = bisected(coarse.model().scene(),
                         *marked_elements(scene, {result}, 0.1, 0.7));
      }
    BOOST_FAIL("twelve passes do not suffice");
    return 0;
  }
} // namespace

BOOST_AUTO_TEST_CASE(marks_take_fewer_dofs_than_halving_all)
{
  // Of a body that is clamped at both ends and loaded over one half, a stress
  // near the other end.
  const TwoModels truth("/tests/scenes/clamped_laminate.prm",
                        {"Theory=LE-1",
                         "Body beam/Kinematics/Axis elements=auto 3",
                         "Section laminate/Cells across=2",
                         "Load patch/Pressure=if(y > 9, 1 + x, 0)"});
  for (const NamedQuantity &goal : {probe_syz, probe_s11})
    for (const double tolerance : {1e-2, 1e-3})
      {
        const double value = ResultNumbers(truth.fine.results()).value(goal);
        const unsigned int by_goal =
                             dofs_to_reach(goal, value, tolerance, true),
                           by_all =
                             dofs_to_reach(goal, value, tolerance, false);
        BOOST_TEST_MESSAGE(goal.label()
                           << " to " << tolerance << ": by the goal " << by_goal
                           << " DoFs, by all elements " << by_all);
        BOOST_TEST(by_goal < by_all);
      }
}

BOOST_AUTO_TEST_SUITE_END()
