// SPDX-License-Identifier: LGPL-2.1-or-later

// Load steps go from a state to a state: along a path, beside it, and on from a
// state that was kept.

#include <lamella/base/exceptions.h>
#include <lamella/run/built_scene.h>
#include <lamella/solve/load_path.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <ostream>

BOOST_AUTO_TEST_SUITE(load_path)

using namespace lamella;

namespace
{
  /// Two blocks that are pressed on each other, and what does their steps.
  struct BlocksInContact
  {
    std::ostream                  nowhere{nullptr};
    dealii::TimerOutput           timer{nowhere,
                              dealii::TimerOutput::never,
                              dealii::TimerOutput::wall_times};
    std::unique_ptr<BuiltScene>   built;
    std::unique_ptr<LinearSystem> solver;
    std::shared_ptr<LoadStep>     step;

    explicit BlocksInContact(const std::vector<std::string> &overrides = {})
    {
      const Scene scene = read_scene(SceneText::read(
        LAMELLA_SOURCE_DIR "/tests/scenes/blocks_in_contact.prm", overrides));
      built = std::make_unique<BuiltScene>(scene, FieldRules(), nowhere, timer);
      solver = std::make_unique<LinearSystem>(linearized(built->structure()),
                                              built->rows());
      step =
        std::make_shared<LoadStep>(std::make_unique<NonlinearSolver>(*solver),
                                   built->interfaces(),
                                   built->contact_objects(),
                                   built->scene().supports.size(),
                                   built->scene().solve,
                                   timer);
    }
  };



  double
  difference(const State &a, const State &b)
  {
    BlockVector u = a.u;
    u -= b.u;
    return u.linfty_norm() / b.u.linfty_norm();
  }
} // namespace



BOOST_AUTO_TEST_CASE(a_path_goes_up_and_down)
{
  // Contact without friction forgets: on the way down the states are those of
  // the way up.
  BlocksInContact         blocks;
  LoadPath                path(blocks.step, {0.5, 1., 0.5});
  std::vector<SolvedStep> steps;
  while (path.has_more())
    {
      BOOST_TEST(path.n_done() == steps.size());
      BOOST_TEST(path.next_factor().of_scene() ==
                 (steps.size() == 1 ? 1. : 0.5));
      steps.push_back(path.advance());
      BOOST_TEST(difference(path.state(), steps.back().state) == 0.);
    }
  BOOST_TEST(steps.size() == 3u);
  BOOST_TEST(!steps[0].state.active.empty());
  BOOST_TEST(difference(steps[2].state, steps[0].state) < 1e-11);
  BOOST_TEST(difference(steps[1].state, steps[0].state) > 0.1);
}



BOOST_AUTO_TEST_CASE(a_path_that_goes_on_is_the_same_path)
{
  BlocksInContact  blocks, others;
  LoadPath         path(blocks.step, {0.5, 1.});
  const SolvedStep kept   = path.advance();
  const auto       memory = blocks.solver->contact_strategy().memory();
  const State      whole  = path.advance().state;
  LoadPath         rest(others.step, {0.5, 1.});
  others.solver->contact_strategy().restore(memory);
  rest.resume(1, kept.state);
  BOOST_TEST(rest.n_done() == 1u);
  const State resumed = rest.advance().state;
  BOOST_TEST(!rest.has_more());
  BOOST_TEST(difference(resumed, whole) == 0.);
  BOOST_TEST(resumed.force == whole.force, boost::test_tools::per_element());
}



BOOST_AUTO_TEST_CASE(histories_superpose)
{
  // A linear scene: what each history alone comes to, times its factor.
  const auto solved = [](const std::vector<std::string> &overrides) {
    std::vector<std::string> all{"Contacts=", "Load factors=1, 0.5"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    BlocksInContact blocks(all);
    LoadPath        path(blocks.step, blocks.built->scene().solve.load_factors);
    std::vector<SolvedStep> steps;
    while (path.has_more())
      steps.push_back(path.advance());
    return steps;
  };
  const std::string floor = "Support floor/u=0, 0, 1e-4",
                    ends  = "Support ends/u=0, 1e-3, 0",
                    still = "Load press/Pressure=0";
  const State press       = solved({})[0].state,
              lift        = solved({floor, still})[0].state,
              pull        = solved({ends, still})[0].state;
  const auto together     = solved(
    {floor, ends, "Load press/Factors=-0.3, 2", "Support ends/Factors=0.7, 0"});
  for (unsigned int k = 0; k < 2; ++k)
    {
      BlockVector u = together[k].state.u;
      u.add(k == 0 ? 0.3 : -2., press.u);
      u.add(k == 0 ? -1. : -0.5, lift.u);
      u.add(k == 0 ? -0.7 : 0., pull.u);
      BOOST_TEST(u.linfty_norm() < 1e-12 * together[k].state.u.linfty_norm());
      BOOST_TEST(together[k].checks.energy_balance < 1e-12);
      BOOST_TEST(together[k].checks.force_balance < 1e-9);
    }
  const Scene scene = read_scene(
    SceneText::read(LAMELLA_SOURCE_DIR "/tests/scenes/blocks_in_contact.prm",
                    {"Load factors=1, 0.5", "Support ends/Factors=3, 4"}));
  BOOST_TEST(scene.solve.load_factors[1].of(1) == 4.);
  BOOST_TEST(scene.solve.load_factors[1].without_loads().of(1) == 0.);
}



BOOST_AUTO_TEST_CASE(friction_remembers_the_path)
{
  const double                   mu = 0.05;
  const std::vector<std::string> rubs{"Contact faces/Friction=0.05"};
  BlocksInContact                blocks(rubs), others(rubs);
  LoadPath                       path(blocks.step, {0.5, 1., 0.9, 0.5});
  std::vector<State>             states;
  StrategyHistory                memory;
  while (path.has_more())
    {
      if (states.size() == 2)
        memory = blocks.solver->contact_strategy().memory();
      states.push_back(path.advance().state);
    }
  // On the way down it is not where it was on the way up.
  BOOST_TEST(difference(states[3], states[0]) > 1e-4);

  const GapConstraints &rows   = blocks.built->rows();
  double                before = 0.;
  std::array<bool, 2>   seen{};
  for (unsigned int k = 0; k < states.size(); ++k)
    {
      const FrictionState &friction = states[k].friction;
      const double         largest =
        *std::max_element(states[k].force.begin(), states[k].force.end());
      for (unsigned int r = 0; r < rows.size(); ++r)
        {
          const double bound = mu * states[k].force[r],
                       shear = friction.shear[r].norm();
          BOOST_TEST(shear <= bound + 1e-9 * largest);
          const bool slips = friction.direction[r].norm() > 0.;
          seen[slips]      = true;
          if (!slips)
            continue;
          BOOST_TEST(std::abs(shear - bound) < 1e-9 * largest);
          // Against the slip of this step.
          dealii::Tensor<1, 3> slip = friction.before[r];
          if (k > 0)
            slip -= states[k - 1].friction.before[r];
          BOOST_TEST(friction.shear[r] * slip <= 0.);
        }
      BOOST_TEST(friction.all_dissipated() >= before);
      before = friction.all_dissipated();
    }
  BOOST_TEST(before > 0.);
  BOOST_TEST((seen[0] && seen[1]));

  LoadPath rest(others.step, {0.5, 1., 0.9, 0.5});
  others.solver->contact_strategy().restore(memory);
  rest.resume(2, states[1]);
  rest.advance();
  const State resumed = rest.advance().state;
  BOOST_TEST(difference(resumed, states[3]) == 0.);
  for (unsigned int r = 0; r < rows.size(); ++r)
    BOOST_TEST(
      (resumed.friction.shear[r] - states[3].friction.shear[r]).norm() == 0.);
}



BOOST_AUTO_TEST_CASE(substeps_are_steps_between)
{
  const std::vector<std::string> rubs{"Contact faces/Friction=0.05"};
  BlocksInContact                blocks(rubs);
  LoadPath                       by_steps(blocks.step,
                    {0.25, 0.5, 0.75, 1., 0.875, 0.75, 0.625, 0.5}),
    by_parts(blocks.step, {1., 0.5}, {4});
  State last;
  while (by_steps.has_more())
    last = by_steps.advance().state;
  by_parts.advance();
  const SolvedStep solved = by_parts.advance();
  BOOST_TEST(solved.substeps == 4u);
  BOOST_TEST(!solved.change.has_value());
  BOOST_TEST(difference(solved.state, last) < 1e-12);
  BOOST_TEST(!last.friction.history.empty());
  for (const auto &[point, history] : last.friction.history)
    BOOST_TEST(solved.state.friction.history.at(point).dissipated ==
               history.dissipated);

  // As many as a tolerance wants, ...
  const double     tolerance = 0.02;
  LoadPath         path(blocks.step, {1., 0.4}, {0, tolerance});
  const SolvedStep first  = path.advance();
  const State      before = path.state();
  const SolvedStep found  = path.advance();
  // More than any force of the way back.
  const double force = first.checks.contacts[0].force.norm();
  BOOST_REQUIRE(found.change.has_value());
  BOOST_TEST(*found.change <= tolerance);
  std::vector<SolvedStep> ways;
  for (const unsigned int n : {found.substeps / 2, found.substeps})
    {
      LoadPath way(blocks.step, {1., 0.4}, {n});
      way.resume(1, before);
      ways.push_back(way.advance());
    }
  BOOST_TEST(std::abs(change_of(ways[1], ways[0], before, force) -
                      *found.change) < 1e-9);
  // A path that goes on measures by the same largest force.
  LoadPath resumed(blocks.step, {1., 0.4}, {0, tolerance});
  resumed.resume(1, before);
  const SolvedStep again = resumed.advance();
  BOOST_TEST(again.substeps == found.substeps);
  BOOST_TEST(std::abs(*again.change - *found.change) < 1e-9);

  // ... and no more than there may be.
  LoadPath endless(blocks.step, {1., 0.4}, {0, 1e-14});
  endless.resume(1, before);
  const SolvedStep most = endless.advance();
  BOOST_TEST(most.substeps == Substeps::most);
  BOOST_TEST(*most.change > 1e-14);
}



BOOST_AUTO_TEST_CASE(work_is_energy_and_what_is_lost)
{
  // Bodies are linear: over each step the mean load's work is what their energy
  // grows by, what friction dissipates, and the gap of the path.
  BlocksInContact blocks(
    {"Contact faces/Friction=0.05", "Contact faces/Enforcement=exact"});
  const auto gap_of = [&](const unsigned int parts) {
    const std::vector<LoadFactor> factors{1., 0.4, 0.8};
    std::vector<LoadFactor>       all;
    for (unsigned int k = 0; k < factors.size(); ++k)
      for (unsigned int j = 1; j <= parts; ++j)
        all.push_back(factors[k].after(k == 0 ? LoadFactor() : factors[k - 1],
                                       1. * j / parts));
    LoadPath         path(blocks.step, all);
    const Structure &structure = blocks.built->structure();
    BlockVector      u         = structure.zero();
    double           work = 0., energy = 0., before = 0.;
    while (path.has_more())
      {
        const double     now    = path.next_factor().of_scene();
        const SolvedStep solved = path.advance();
        BlockVector      way    = solved.state.u;
        way -= u;
        work += structure.load(0.5 * (now + before)) * way;
        u      = solved.state.u;
        energy = solved.checks.energy;
        before = now;
      }
    const FrictionState &friction = path.state().friction;
    const double         lost = friction.path_gap + friction.all_dissipated();
    BOOST_TEST(std::abs(work - energy - lost) < 1e-10 * energy);
    return friction.path_gap / energy;
  };
  const double of_one = std::abs(gap_of(1)), of_eight = std::abs(gap_of(8));
  BOOST_TEST(of_one > 1e-9);
  BOOST_TEST(of_eight < 0.3 * of_one);
}



BOOST_AUTO_TEST_CASE(branches_leave_the_path_where_it_is)
{
  BlocksInContact blocks;
  LoadPath        path(blocks.step, {0.5, 1.}, {}, true);
  path.advance();
  const State at = path.state();
  // Between the stored ones, before the first, beyond the last, and back.
  const State far = path.branch(2., 1).state, near = path.branch(0.25, 1).state,
              between = path.branch(0.75, 1).state;
  BOOST_TEST(difference(path.state(), at) == 0.);
  BOOST_TEST(path.n_done() == 1u);
  const auto straight = [&](const double factor) {
    return (*blocks.step)(State(), 0., factor).state;
  };
  BOOST_TEST(difference(far, straight(2.)) < 1e-11);
  BOOST_TEST(difference(near, straight(0.25)) < 1e-11);
  BOOST_TEST(difference(between, straight(0.75)) < 1e-11);
}



BOOST_AUTO_TEST_CASE(branches_go_the_path_where_bodies_rub)
{
  BlocksInContact blocks({"Contact faces/Friction=0.05"});
  const auto      by_path = [&](const std::vector<LoadFactor> &factors) {
    LoadPath way(blocks.step, factors);
    while (way.has_more())
      way.advance();
    return way.state();
  };
  LoadPath path(blocks.step, {1., 0.4, 0.8}, {}, true);
  while (path.has_more())
    path.advance();
  // On the way back, from its start; then from what it has passed, and no more
  // from what is ahead; and on the way after the last step.
  BOOST_TEST(difference(path.branch(0.6, 1).state, by_path({1., 0.6})) < 1e-12);
  BOOST_TEST(difference(path.branch(0.8, 1).state, by_path({1., 0.8})) < 1e-12);
  BOOST_TEST(difference(path.branch(0.5, 1).state, by_path({1., 0.6, 0.5})) <
             1e-12);
  BOOST_TEST(difference(path.branch(1.2, 3).state,
                        by_path({1., 0.4, 0.8, 1.2})) < 1e-12);
  // The way matters: loaded straight to 0.6, or unloaded to it.
  BOOST_TEST(difference(path.branch(0.6, 1).state, by_path({0.6})) > 1e-4);

  // A path that has been resumed does not know the ways before.
  LoadPath resumed(blocks.step, {1., 0.4, 0.8}, {}, true);
  resumed.resume(3, path.state());
  BOOST_TEST(difference(resumed.branch(0.6, 1).state, by_path({1., 0.6})) <
             1e-12);
}



BOOST_AUTO_TEST_CASE(a_path_stays_where_a_step_fails)
{
  BlocksInContact blocks({"Rotation limit=1e-3"});
  LoadPath        path(blocks.step, {0.01, 1e6});
  path.advance();
  const State at = path.state();
  BOOST_CHECK_THROW(path.advance(), NumericsError);
  BOOST_TEST(path.n_done() == 1u);
  BOOST_TEST(difference(path.state(), at) == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
