// SPDX-License-Identifier: LGPL-2.1-or-later

// Which pass of a run to a tolerance follows which: no model is solved.

#include <lamella/estimate/passes.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace lamella;

BOOST_AUTO_TEST_SUITE(passes)

namespace
{
  using Shares = std::vector<std::pair<std::string, double>>;

  /// A goal that may be off by 1e-2 of about 1, and what sources have of its
  /// bar.
  GoalResult
  goal_of(const double value, const Shares &shares)
  {
    GoalResult goal;
    goal.name      = "tip: uz";
    goal.value     = value;
    goal.scale     = 1.;
    goal.tolerance = Tolerance{1e-2};
    goal.trusted   = true;
    goal.shares    = shares;
    for (const auto &[name, share] : shares)
      goal.bar += std::abs(share);
    return goal;
  }

  GoalResult
  goal_without_bar(const double value,
                   const double axis    = 0.5,
                   const double section = 0.01)
  {
    GoalResult goal = goal_of(value, {{"axis", axis}, {"section", section}});
    goal.trusted    = false;
    goal.estimate   = 0.3;
    goal.why        = "it grows";
    return goal;
  }

  Pass
  pass_of(const std::vector<GoalResult> &goals)
  {
    Pass pass;
    pass.goals = goals;
    return pass;
  }
} // namespace

BOOST_AUTO_TEST_CASE(sources_are_wanted_until_the_rest_is_half_of_the_tolerance)
{
  struct LinearFunctional
  {
    Shares              shares;
    std::vector<Source> wanted;
  };
  const std::vector<LinearFunctional> table{
    {{{"axis", 0.02}, {"section", -0.0045}}, {Source::axis}},
    {{{"axis", 0.02}, {"section", -0.0055}}, {Source::axis, Source::section}},
    // Two that are small alone are not together.
    {{{"axis", 0.02}, {"section", -3e-3}, {"contact", 3e-3}},
     {Source::axis, Source::section}},
    {{{"axis", 1e-3}, {"fields", 0.1}, {"section", 1e-3}}, {Source::fields}},
    {{{"axis and section", 0.1}, {"contact", 1e-3}},
     {Source::axis, Source::section}}};
  for (const LinearFunctional &row : table)
    BOOST_TEST_CONTEXT("row " << &row - table.data())
    {
      Passes passes;
      passes.add(pass_of({goal_of(1., row.shares)}));
      BOOST_TEST(!passes.all_goals_met());
      BOOST_TEST((passes.wanted() == row.wanted));
      BOOST_TEST(passes.reason_to_stop().empty());
    }
}



BOOST_AUTO_TEST_CASE(degrees_stall_where_more_than_half_is_left)
{
  const auto is_stalled = [](const double               left,
                             const std::vector<Source> &refined,
                             const double               tolerance = 1e-2) {
    const auto goal = [tolerance](const double share) {
      GoalResult one = goal_of(1., {{"axis", 0.02}, {"section", share}});
      one.tolerance  = Tolerance{tolerance};
      return one;
    };
    Passes passes;
    passes.add(pass_of({goal(-0.05)}));
    passes.add(pass_of({goal(left)}), {refined});
    return passes.degrees_stall();
  };
  const std::vector<Source> both{Source::axis, Source::section};
  BOOST_TEST(!is_stalled(0.024, both));
  BOOST_TEST(is_stalled(0.026, both));
  // Elements say nothing of degrees, and what is small need not contract.
  BOOST_TEST(!is_stalled(0.026, {Source::axis}));
  BOOST_TEST(!is_stalled(0.026, both, 0.06));
}



BOOST_AUTO_TEST_CASE(fields_may_stand_in_where_half_of_the_tolerance_is_left)
{
  Passes passes;
  passes.add(pass_of({goal_of(1., {{"axis", 0.02}})}));
  BOOST_TEST(passes.is_loss_acceptable({4.9e-3}));
  BOOST_TEST(!passes.is_loss_acceptable({5.1e-3}));
  // What they lose is the least that the fields have of a bar.
  for (const double lost : {1e-3, 4e-3})
    {
      GoalResult goal = goal_of(1., {{"axis", 0.02}, {"fields", -2e-3}});
      raise_share(goal, Source::fields, lost);
      const double expected = std::max(lost, 2e-3);
      BOOST_TEST(std::abs(goal.bar - (0.02 + expected)) < 1e-15);
      BOOST_TEST(std::abs(goal.shares[1].second + expected) < 1e-15);
    }
}



BOOST_AUTO_TEST_CASE(a_number_without_limit_leaves_and_keeps_no_other)
{
  const GoalResult open = goal_of(1., {{"axis", 0.03}, {"section", 1e-3}}),
                   met  = goal_of(1., {{"axis", 3e-3}, {"section", 1e-3}});
  Passes passes;
  passes.add(pass_of({open, goal_without_bar(1.)}));
  // A pass is made for those that have a bar; the other one sees what it does.
  BOOST_TEST((passes.wanted() == std::vector<Source>{Source::axis}));
  BOOST_TEST(passes.dropped_goals().empty());
  passes.add(pass_of({met, goal_without_bar(1.2)}), {{Source::axis}});
  BOOST_REQUIRE(passes.dropped_goals().size() == 1u);
  BOOST_TEST(passes.dropped_goals().front() ==
             "no further refinement pass is made for tip: uz: it grows");
  BOOST_TEST(passes.open_goals().empty());
  BOOST_TEST(!passes.all_goals_met());
  BOOST_TEST(!passes.reason_to_stop().empty());
  // Told once.
  passes.add(pass_of({met, goal_without_bar(1.4)}), {{Source::axis}});
  BOOST_TEST(passes.dropped_goals().empty());

  // Of some places it is known before: no pass has to show it.
  GoalResult known = goal_without_bar(1.);
  known.has_limit  = false;
  known.why        = "below a load";
  Passes first;
  first.add(pass_of({open, known}));
  BOOST_REQUIRE(first.dropped_goals().size() == 1u);
  BOOST_TEST(first.dropped_goals().front() ==
             "no further refinement pass is made for tip: uz: below a load");

  // What settles may have its bar yet.
  Passes settling;
  settling.add(pass_of({goal_without_bar(1.)}));
  settling.add(pass_of({goal_without_bar(1.005)}), {{Source::section}});
  BOOST_TEST(settling.open_goals().size() == 1u);
}



BOOST_AUTO_TEST_CASE(a_bar_that_no_pass_shortens_ends_the_run)
{
  Passes     passes;
  const auto add = [&](const double bar) {
    passes.add(pass_of({goal_of(1., {{"axis", bar}})}), {{Source::contact}});
    return passes.reason_to_stop().empty();
  };
  // A third less than the longer one of two passes before is enough.
  BOOST_TEST(add(0.03));
  BOOST_TEST(add(0.1));
  BOOST_TEST(add(0.066));
  BOOST_TEST(add(0.065));
  BOOST_TEST(!add(0.045));
  // The first bar of a goal has none to be shorter than.
  Passes     late;
  const auto add_first = [&late](const GoalResult &goal) {
    late.add(pass_of({goal}), {{Source::axis}});
  };
  add_first(goal_without_bar(1.));
  add_first(goal_without_bar(1.001));
  add_first(goal_of(1.002, {{"axis", 0.5}}));
  BOOST_TEST(late.dropped_goals().empty());
}



BOOST_AUTO_TEST_CASE(cells_are_divided_before_a_number_is_given_up)
{
  const auto dividing = [](const bool divides) {
    PassRefinement refined;
    refined.sources       = {Source::section};
    refined.divides_cells = divides;
    return refined;
  };
  const auto of_section = [](const double value) {
    return pass_of({goal_without_bar(value, 0.01, 0.5)});
  };
  Passes passes;
  passes.add(of_section(1.));
  passes.add(of_section(1.2), dividing(false));
  // No bar, and large changes: but by a higher degree alone.
  BOOST_TEST(passes.dropped_goals().empty());
  BOOST_TEST(passes.degrees_stall());
  Passes other = passes;
  // A long bar is a beginning; two more passes have to shorten it.
  const auto with_bar = [](const double bar) {
    return pass_of({goal_of(1.1, {{"axis", 0.01}, {"section", bar}})});
  };
  passes.add(with_bar(2.), dividing(true));
  passes.add(with_bar(1.9), dividing(false));
  BOOST_TEST(passes.dropped_goals().empty());
  passes.add(with_bar(1.8), dividing(false));
  BOOST_REQUIRE(passes.dropped_goals().size() == 1u);
  BOOST_TEST(passes.dropped_goals().front() ==
             "no further refinement pass is made for tip: uz: its error bar "
             "has not decreased by a third in two passes");
  // If it has none after that, there is no other remedy.
  other.add(of_section(1.1), dividing(true));
  BOOST_TEST(other.dropped_goals().size() == 1u);
}



BOOST_AUTO_TEST_CASE(a_growing_goal_does_not_wait_for_smaller_cells)
{
  // No bar, the section's error is the largest; changes of 0.2 and 0.05 or 0.3.
  const auto without_bar = [](const double value) {
    GoalResult goal = goal_of(value, {{"section", 0.3}});
    goal.trusted    = false;
    goal.estimate   = 0.3;
    return pass_of({goal});
  };
  for (const double last : {1.25, 1.5})
    {
      Passes passes;
      passes.add(without_bar(1.));
      passes.add(without_bar(1.2), {{Source::section}});
      BOOST_TEST(passes.dropped_goals().empty());
      passes.add(without_bar(last), {{Source::section}});
      BOOST_TEST(passes.dropped_goals().size() == (last > 1.4 ? 1u : 0u));
    }
}



BOOST_AUTO_TEST_CASE(seconds_are_predicted_by_operations)
{
  Passes passes;
  Pass   pass     = pass_of({goal_of(1., {{"axis", 0.03}})});
  pass.operations = 1e10;
  pass.seconds    = 3.;
  passes.add(pass);
  BOOST_TEST(std::abs(passes.predicted_seconds(8e10) - 24.) < 1e-12);
  // Small models take what their overhead takes.
  pass.operations = 1e6;
  pass.seconds    = 5.;
  passes.add(pass, {{Source::axis}});
  BOOST_TEST(std::abs(passes.predicted_seconds(1e7) - 2.) < 1e-12);
  BOOST_TEST(std::abs(passes.predicted_seconds(2e10) - 8.) < 1e-12);
}



BOOST_AUTO_TEST_CASE(what_a_bar_did_not_know_of_is_another_pass)
{
  Passes passes;
  passes.add(pass_of({goal_of(1., {{"axis", 4e-3}, {"section", 1e-3}}),
                      goal_of(2., {{"axis", 0.05}, {"section", 1e-3}})}));
  const auto second = [](const double value) {
    return pass_of({goal_of(value, {{"axis", 4e-3}, {"section", 1e-3}}),
                    goal_of(2., {{"axis", 1e-3}, {"section", 1e-3}})});
  };
  Passes other = passes;
  passes.add(second(1.0049), {{Source::axis}});
  BOOST_TEST(passes.all_goals_met());
  // Within its tolerance, and further than its bar.
  other.add(second(1.0051), {{Source::axis}});
  BOOST_TEST(!other.all_goals_met());
  BOOST_TEST(other.reason_to_stop().empty());
  BOOST_TEST((other.wanted() == std::vector<Source>{Source::axis}));
  BOOST_TEST(std::abs(other.largest_change() - 0.51) < 1e-9);
}



BOOST_AUTO_TEST_CASE(passes_that_change_less_and_less_shorten_bars)
{
  // b = 0.08, d = 0.02, d_1 = 0.08: q = 1/4, 2 d q / (1 - q) = 0.0133 < d.
  const GoalResult first  = goal_of(0.92, {{"axis", 0.3}}),
                   before = goal_of(1., {{"axis", 0.08}, {"section", -4e-3}});
  const auto after = [&](const double value, const PassRefinement &refined) {
    GoalResult goal = goal_of(value, {{"axis", 0.05}, {"section", -3e-3}});
    shorten(goal, {first, before, refined, refined});
    return goal;
  };
  const PassRefinement of_axis{{Source::axis}},
    of_both{{Source::axis, Source::section}};
  BOOST_TEST(std::abs(after(1.02, of_axis).bar - 0.023) < 1e-12);
  BOOST_TEST(std::abs(after(1.02, of_axis).shares[0].second - 0.02) < 1e-12);
  BOOST_TEST(after(1.02, of_axis).shares[1].second == -3e-3);
  // q = 1/2: 2 d q / (1 - q) = 0.08 is more than its own.
  BOOST_TEST(std::abs(after(1.04, of_axis).bar - 0.053) < 1e-12);
  // No less than b / 8: a change may be small by accident.
  BOOST_TEST(std::abs(after(1.0001, of_axis).bar - 0.013) < 1e-12);
  // Of what was not refined its own bar stays.
  BOOST_TEST(std::abs(after(1.0001, {{Source::contact}}).bar - 0.053) < 1e-12);
  // b = 0.084 of both.
  BOOST_TEST(std::abs(after(1.0001, of_both).bar - 0.0105) < 1e-12);
  // Sources that were refined one after the other say nothing of each other.
  GoalResult goal = goal_of(1.0001, {{"axis", 0.05}, {"section", -3e-3}});
  shorten(goal, {first, before, {{Source::section}}, of_axis});
  BOOST_TEST(std::abs(goal.bar - 0.053) < 1e-12);
}



BOOST_AUTO_TEST_CASE(what_goes_on_is_not_taken_for_settled)
{
  // A re-entrant corner: each degree leaves 0.63 of the error, and a bar before
  // that is twice too wide hides it.
  const auto error = [](const int k) { return 0.1 * std::pow(0.63, k); };
  GoalResult goal  = goal_of(1. + error(2), {{"section", 0.3}});
  const PassRefinement refined{{Source::section}};
  shorten(goal,
          {goal_of(1. + error(0), {{"section", 0.4}}),
           goal_of(1. + error(1), {{"section", 0.2}}),
           refined,
           refined});
  BOOST_TEST(goal.bar >= error(2));
}



BOOST_AUTO_TEST_CASE(elements_that_were_not_bisected_count)
{
  GoalResult before = goal_of(1., {{"axis", 0.08}}),
             goal   = goal_of(1.0001, {{"axis", 0.05}});
  before.local = LocalErrors{{{0, 0., 1., 0.076, 9}, {0, 1., 2., -4e-3, 9}}};
  const PassRefinement one{{Source::axis},
                           std::vector<ElementError>{{0, 0., 1., 0.076, 9}}};
  shorten(goal, {goal_of(0.9, {{"axis", 1.}}), before, one, one});
  BOOST_TEST(std::abs(goal.bar - 0.014) < 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()
