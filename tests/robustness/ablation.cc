// SPDX-License-Identifier: LGPL-2.1-or-later

// Usage: ablation SCENE [SUBSECTION/ENTRY=VALUE...]
//
// Solves a scene once and computes the error bars of its goals with each rule
// of EstimateRules off in turn; a scene with a Tolerance is run to it with each
// rule of refinement off. Prints CSV: rule, goal, value, scale, bar, trusted
// (met, with a Tolerance), has_limit (passes), seconds (of all).

#include <lamella/base/processes.h>
#include <lamella/estimate/comparison.h>
#include <lamella/estimate/tolerance_run.h>
#include <lamella/scene/scene_text.h>

#include <deal.II/base/timer.h>

#include <iostream>
#include <limits>

using namespace lamella;

namespace
{
  constexpr double infinite = std::numeric_limits<double>::max();

  /// A rule, and the values with which it decides nothing.
  struct Variant
  {
    const char *name;
    void (*set)(EstimateRules &);
  };

  const Variant variants[] = {
    {"as it is", [](EstimateRules &) {}},
    {"safety = 1", [](EstimateRules &rules) { rules.safety = 1.; }},
    {"max_remaining_share = 0.9",
     [](EstimateRules &rules) { rules.max_remaining_share = 0.9; }},
    {"max_section_ratio off",
     [](EstimateRules &rules) { rules.max_section_ratio = infinite; }},
    {"small = 0", [](EstimateRules &rules) { rules.small = 0.; }},
    {"digits = 0", [](EstimateRules &rules) { rules.digits = 0.; }},
    {"min_share_of_previous = 0",
     [](EstimateRules &rules) { rules.min_share_of_previous = 0.; }},
    {"min_degree = 4", [](EstimateRules &rules) { rules.min_degree = 4; }},
    {"fewer_waves = 1", [](EstimateRules &rules) { rules.fewer_waves = 1; }},
    {"of_axis = 0", [](EstimateRules &rules) { rules.of_axis = 0.; }},
    {"max_change_share off",
     [](EstimateRules &rules) { rules.max_change_share = infinite; }},
    {"of_path = 2", [](EstimateRules &rules) { rules.of_path = 2.; }},
    {"longest_at_support off",
     [](EstimateRules &rules) { rules.longest_at_support = infinite; }},
    {"min_total_share = 1",
     [](EstimateRules &rules) { rules.min_total_share = 1.; }},
    {"of_shares = 0", [](EstimateRules &rules) { rules.of_shares = 0.; }}};



  const Variant pass_variants[] = {
    {"as it is", [](EstimateRules &) {}},
    {"max_unrefined_share = 0.9",
     [](EstimateRules &rules) { rules.max_unrefined_share = 0.9; }},
    {"max_degree_ratio off",
     [](EstimateRules &rules) { rules.max_degree_ratio = infinite; }},
    {"max_axis_remainder = 0.5",
     [](EstimateRules &rules) { rules.max_axis_remainder = 0.5; }},
    {"min_bisected_share = 0",
     [](EstimateRules &rules) { rules.min_bisected_share = 0.; }},
    {"min_bisected_share = 1",
     [](EstimateRules &rules) { rules.min_bisected_share = 1.; }},
    {"min_share_of_previous = 0",
     [](EstimateRules &rules) { rules.min_share_of_previous = 0.; }},
    {"slow_passes off", [](EstimateRules &rules) { rules.slow_passes = 99; }},
    {"patience off", [](EstimateRules &rules) { rules.patience = 99; }}};



  void
  print_passes(const Scene &scene, const Variant &variant)
  {
    std::ostream  nowhere(nullptr);
    EstimateRules rules;
    variant.set(rules);
    const dealii::Timer wall;
    ToleranceRun        run(scene, nowhere, rules);
    run.run("ablation");
    for (const GoalResult &goal : run.results().goals)
      std::cout << variant.name << ',' << goal.name << ',' << goal.value << ','
                << goal.scale << ',' << goal.bar << ',' << goal.met() << ','
                << run.results().n_dofs() << ',' << wall.wall_time() << '\n';
  }



  void
  print_bars(const Simulation &run, const Variant &variant, ModelCache &cache)
  {
    std::ostream  nowhere(nullptr);
    EstimateRules rules;
    variant.set(rules);
    const dealii::Timer wall;
    const GoalBars      bars = error_bars_of(run, nowhere, cache, rules);
    for (const GoalResult &goal : bars.goals)
      std::cout << variant.name << ',' << goal.name << ',' << goal.value << ','
                << goal.scale << ',' << goal.bar << ',' << goal.trusted << ','
                << goal.has_limit << ',' << wall.wall_time() << '\n';
  }
} // namespace



int
main(int argc, char **argv)
{
  MpiSession mpi(argc, argv);
  return run_and_report([&] {
    const Scene scene = read_scene(
      SceneText::read(argv[1],
                      std::vector<std::string>(argv + 2, argv + argc)));
    std::cout.precision(12);
    std::cout << "rule,goal,value,scale,bar,trusted,has_limit,seconds\n";
    if (!scene.goals.tolerances.empty())
      {
        for (const Variant &variant : pass_variants)
          print_passes(scene, variant);
        return;
      }
    std::ostream nowhere(nullptr);
    Simulation   run(scene, nowhere);
    run.solve();
    ModelCache cache;
    for (const Variant &variant : variants)
      print_bars(run, variant, cache);
  });
}
