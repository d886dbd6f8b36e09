// SPDX-License-Identifier: LGPL-2.1-or-later

// Bars from poorer models, from models on half of the axis and from exact rows
// in the place of penalties, against models that are solved.

#include <lamella/estimate/comparison.h>
#include <lamella/estimate/surpluses.h>

#include "quantities.h"
#include "solved_scene.h"
#include <boost/test/unit_test.hpp>

#include <cmath>

BOOST_AUTO_TEST_SUITE(coarser_models)

using namespace lamella;

namespace
{
  /// A scene that is solved, and bars of its first goal.
  struct Solved : SolvedScene
  {
    using SolvedScene::SolvedScene;

    GoalResult
    by(const Recipe &recipe)
    {
      return Comparison(run, recipe, nowhere, cache).goals().front();
    }

    GoalResult
    from_below()
    {
      return by(coarser_model_recipe(run));
    }

    GoalResult
    halved_axis(const HalvedAxisPlan &plan = {})
    {
      return by(halved_axis_recipe(run, plan));
    }

    GoalResult
    by_source()
    {
      return by(single_source_recipe(run));
    }

    ModelCache cache;
  };



  AxisMesh
  axis_of(const std::vector<double> &lengths)
  {
    AxisMesh axis;
    for (const double length : lengths)
      {
        if (axis.length > 0.)
          axis.breaks.push_back(axis.length);
        axis.length += length;
        axis.elements.push_back(1);
      }
    return axis;
  }



  Solved
  crossed(const std::string &theory, const std::vector<std::string> &more = {})
  {
    std::vector<std::string> overrides{"Theory=" + theory,
                                       "Goals/Quantities=cross: fz"};
    overrides.insert(overrides.end(), more.begin(), more.end());
    return {"/tests/scenes/crossed_beams.prm", overrides};
  }



  const NamedQuantity force =
    quantity_of(NamedQuantity::ObjectKind::contact, "cross", "fz");
} // namespace



BOOST_AUTO_TEST_CASE(half_of_the_elements_has_the_same_ends)
{
  // Equal elements; of an odd number three are one.
  AxisMesh equal;
  equal.length   = 7.;
  equal.elements = {4, 3};
  equal.breaks   = {4.};
  BOOST_TEST(element_lengths(halved(equal)) ==
               (std::vector<double>{2., 2., 3.}),
             boost::test_tools::per_element());
  // Graded to a place in the middle and to one end: both stay.
  const AxisMesh graded = axis_of({4., 2., 1., 1., 2., 4., 4., 2., 1.});
  BOOST_TEST(element_lengths(halved(graded)) ==
               (std::vector<double>{7., 3., 10., 1.}),
             boost::test_tools::per_element());
  BOOST_TEST(element_lengths(halved(axis_of({3.}))).size() == 1u);
  // What bisection divided is together again, beside a graded part as well.
  AxisMesh divided = graded;
  divided.elements = {1, 1, 4, 4, 1, 1, 1, 1, 1};
  BOOST_TEST(element_lengths(halved(divided)) ==
               (std::vector<double>{6., 0.5, 0.5, 0.5, 0.5, 6., 6., 1.}),
             boost::test_tools::per_element());
}



BOOST_AUTO_TEST_CASE(an_element_without_a_partner_loses_a_degree)
{
  const std::vector<AxisSpan> once  = coarser_spans(axis_of({1., 1., 1.}), 1),
                              twice = coarser_spans(axis_of({1., 1., 1.}), 2);
  BOOST_TEST(once.size() == 1u);
  BOOST_TEST(once[0].degree == 3u);
  BOOST_TEST(twice.size() == 1u);
  BOOST_TEST(twice[0].degree == 2u);
  BOOST_TEST(coarser_spans(axis_of({1.}), 2).front().degree == 1u);
}



BOOST_AUTO_TEST_CASE(a_support_s_force_has_the_surplus_of_the_contact_s)
{
  // Which is in equilibrium with it. Without what the dual of a support is
  // less, it is ten times as large.
  const Solved    rich = crossed("LE-3");
  const GoalDual  dual(rich.run);
  const Surpluses surpluses(rich.run);
  const auto      surplus = [&](const NamedQuantity &goal) {
    BlockVector z = dual.solve(*dual.derivative(goal)).u;
    if (const auto w = dual.lifting(goal))
      z -= *w;
    return surpluses.of(z);
  };
  const SurplusParts contact = surplus(force),
                     support = surplus(quantity_of(
                       NamedQuantity::ObjectKind::support, "press", "fz"));
  for (const auto &[one, other] :
       {std::make_pair(contact.section, support.section),
        std::make_pair(contact.axis, support.axis)})
    {
      BOOST_TEST(std::abs(other.last) < 2. * std::abs(one.last));
      BOOST_TEST(std::abs(other.last) > 0.5 * std::abs(one.last));
    }
}



BOOST_AUTO_TEST_CASE(exact_rows_on_the_run_s_own_stiffness)
{
  const std::string penalty = "Contact cross/Enforcement=penalty",
                    soft    = "Contact cross/Penalty=200";
  const Solved run = crossed("LE-2", {penalty, soft}), exact = crossed("LE-2");
  const double change = exact.value(force) - run.value(force);
  BOOST_TEST(std::abs(change) > 0.01 * std::abs(run.value(force)));
  GoalResult found;
  ContactShares(run.run).add_to(force, found);
  BOOST_TEST(found.estimate == change, boost::test_tools::tolerance(1e-8));
  BOOST_TEST(found.bar == 2. * std::abs(found.estimate));
}



BOOST_AUTO_TEST_CASE(bars_hold_where_bodies_touch)
{
  // The truth is richer in section and axis.
  const double truth = crossed("LE-4",
                               {"Body upper/Kinematics/Axis elements=3, 4, 3",
                                "Body lower/Kinematics/Axis elements=3, 5, 3"})
                         .value(force);
  const GoalResult rich = crossed("LE-3").from_below(),
                   poor = crossed("LE-2").halved_axis(),
                   thin = crossed("EBBT").halved_axis();
  for (const GoalResult &goal : {rich, poor, thin})
    BOOST_TEST_CONTEXT(goal.value << " +- " << goal.bar << ", truth " << truth)
    {
      BOOST_TEST(goal.trusted);
      BOOST_TEST(std::abs(truth - goal.value) <= goal.bar);
      BOOST_TEST(goal.bar < 0.05 * goal.scale);
    }
}



BOOST_AUTO_TEST_CASE(a_bar_is_no_less_than_the_change_of_solved_models)
{
  // Which see other rows and other active sets than the run's.
  Solved     rich = crossed("LE-3");
  Simulation poor(with_lower_degree(with_halved_axes(rich.run.model().scene())),
                  rich.nowhere);
  const double change =
    rich.value(force) - ResultNumbers(poor.solve()).value(force);
  BOOST_TEST(std::abs(change) > 1e-3 * std::abs(rich.value(force)));
  BOOST_TEST(rich.from_below().bar >= std::abs(change));
}



BOOST_AUTO_TEST_CASE(rows_that_a_surplus_opens_answer_with_its_energy)
{
  // With z = u the surplus is twice the energy of v = (1 - L) u and of the
  // smallest displacement w that closes what v opens: B w = -B v.
  const Solved      rich   = crossed("LE-3");
  const Simulation &run    = rich.run;
  const State      &state  = run.results().last().state;
  const auto       &active = state.active;
  const auto        beams  = beams_of(run.model().structure().bodies());
  BlockVector       v = run.model().structure().zero(), w = v;
  for (unsigned int b = 0; b < beams.size(); ++b)
    v.block(b) = BeamSurplus(*beams[b]).in_section(state.u.block(b), 2);
  Vector jump(active.size()), forces(active.size());
  for (unsigned int k = 0; k < active.size(); ++k)
    jump[k] = -run.model().rows()[active[k]].jump(v);
  run.linear_system().solve_linear(
    active, run.model().structure().zero(), jump, w, forces);
  const TangentOperator &tangent = run.linear_system().tangent();
  const double of_bodies = tangent.apply(v) * v, of_rows = tangent.apply(w) * w;
  // A hundred times what is told apart below.
  BOOST_TEST(of_rows > 1e-4 * of_bodies);
  BOOST_TEST(Surpluses(run).of(state.u).section.last == of_bodies + of_rows,
             boost::test_tools::tolerance(1e-6));
}



BOOST_AUTO_TEST_CASE(a_theory_that_is_far_off_says_so_in_a_number)
{
  // 13 times the force of the sandwich, told for the price of LE-1 on half of
  // the axis.
  Solved               run("/prm/sandwich.prm",
             {"Theory=EBBT", "Goals/Quantities=indentation: fz"});
  const HalvedAxisPlan cheap{1, 1};
  const GoalResult     goal = run.halved_axis(cheap);
  BOOST_TEST(goal.value > 9000.);
  BOOST_TEST(goal.bar > 0.9 * goal.value);
  BOOST_TEST(goal.value - goal.bar < 755.);
  // That is what is taken where nobody asks for bars.
  const auto plan = affordable_plan(run.run, EstimateRules().free_operations);
  BOOST_REQUIRE(plan.has_value());
  BOOST_TEST(plan->degree == cheap.degree);
  BOOST_TEST(plan->times == cheap.times);
  BOOST_TEST(!affordable_plan(run.run, 1.).has_value());
}



BOOST_AUTO_TEST_CASE(a_theory_that_is_no_level_is_not_taken_for_one)
{
  // LE-1 has nothing of what TE-3 and SV lack, and lacks what they have: of a
  // tube of plies both were off alike, and a bar made of their difference was
  // 6.8 times too short.
  for (const char *theory : {"TE-3", "SV"})
    {
      const Solved run("/prm/sandwich.prm", {std::string("Theory=") + theory});
      for (double most = 1e6; most < 1e16; most *= 1.5)
        if (const auto plan = affordable_plan(run.run, most))
          BOOST_TEST(plan->degree == 2u);
      BOOST_TEST(affordable_plan(run.run, 1e16).has_value());
    }
}



BOOST_AUTO_TEST_CASE(bars_of_responses_hold)
{
  const std::string scene = "/tests/scenes/double_t.prm",
                    goals = "Goals/Quantities=edge: uz";
  Solved           run(scene, {"Theory=SV-6", goals});
  const GoalResult goal = run.by_source();
  // LE-6 on a mesh twice as fine (scripts/measure bars).
  const double truth = -0.1304039;
  BOOST_TEST(goal.trusted);
  BOOST_TEST(std::abs(truth - goal.value) <= goal.bar);
  BOOST_TEST(goal.bar < 0.02 * goal.scale);
  BOOST_TEST(goal.shares.size() == 3u);
  // How much of what poorer models change is left nobody has looked at.
  BOOST_TEST(goal.estimate == 0.);

  // With a tolerance models are richer, and what they change is the estimate;
  // elements tell where.
  Solved           wanted(scene, {"Theory=SV-6", goals, "Goals/Tolerance=1"});
  const GoalResult closer = wanted.by_source();
  BOOST_TEST(closer.value == goal.value);
  BOOST_TEST(std::abs(truth - closer.value) <= closer.bar);
  BOOST_TEST(closer.estimate != 0.);
  BOOST_REQUIRE(closer.local.has_value());
  double sum = closer.local->contact + closer.local->remainder;
  for (const ElementError &element : closer.local->elements)
    sum += element.error;
  BOOST_TEST(closer.shares.front().first == "axis");
  // Half of the bar's part is the change.
  BOOST_TEST(std::abs(sum - 0.5 * closer.shares.front().second) <
             1e-9 * goal.scale);
}



BOOST_AUTO_TEST_CASE(what_has_no_bars_of_either_kind_says_why)
{
  BOOST_TEST(
    coarser_model_recipe(crossed("LE-2").run).unavailable.find("LE-3") !=
    std::string::npos);
  BOOST_TEST(
    halved_axis_recipe(crossed("solid-1").run).unavailable.find("solid") !=
    std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
