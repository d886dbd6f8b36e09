// SPDX-License-Identifier: LGPL-2.1-or-later

// step-16: an error bar, held against the true error.
//
// What step-9 leaves is to know the dual and the truth, which nobody does: both
// would take the rich model. So a bar solves richer models of the same scene,
// twice, and looks whether they agree (doc/theory/error-bars.md). The program
// has the library make bars of three goals for six theories, and holds them
// against the true errors. See README.md in this folder.

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/estimate/estimation.h>

#include <deal.II/base/table_handler.h>

#include <cmath>
#include <fstream>
#include <iostream>

using namespace lamella;

namespace
{
  // The beam and the goals of step-9.
  constexpr const char *file = STEP_9_SCENE;
} // namespace



class BarsOfTheories
{
public:
  void
  run();

private:
  void
  add_goal(const std::string &theory,
           const unsigned int n_dofs,
           const GoalResult  &goal,
           const double       true_value);

  dealii::TableHandler table;
  std::ofstream        csv{"step-16.csv"};
};



// What is known of one goal: the true error, what is estimated of it, and the
// bar that it is claimed to be within, all over the scale of the goal. There is
// no bar where the richer models do not agree yet.
void
BarsOfTheories::add_goal(const std::string &theory,
                         const unsigned int n_dofs,
                         const GoalResult  &goal,
                         const double       true_value)
{
  const double      error    = (true_value - goal.value) / goal.scale;
  const double      estimate = goal.estimate / goal.scale;
  const double      bar      = goal.bar / goal.scale;
  const std::string none     = goal.trusted ? "" : "none yet";

  table.add_value("theory, goal", theory + ", " + goal.name);
  table.add_value("DoFs", n_dofs);
  table.add_value("value", goal.value);
  table.add_value("error, %", to_text(100. * error, 3));
  table.add_value("estimated, %", to_text(100. * estimate, 3));
  table.add_value("bar, %", goal.trusted ? to_text(100. * bar, 3) : none);
  table.add_value("error over bar",
                  goal.trusted ? to_text(std::abs(error) / bar, 2) : "");
  csv << theory << "," << n_dofs << "," << goal.name << "," << error << ","
      << estimate << "," << (goal.trusted ? to_text(bar, 6) : "") << "\n";
}



// The truth is LE-4 on a finer axis with more cells across. Estimation does for
// a Simulation what `Error bars = true` does in a scene. Models that several
// theories have in common are solved once, since they share a cache.
void
BarsOfTheories::run()
{
  std::ostream quiet(nullptr);
  const Scene  finest =
    read_scene(SceneText::read(file,
                               {"Theory=LE-4",
                                "Section strip/Cells across=3",
                                "Body beam/Kinematics/Axis elements=auto",
                                "Body beam/Kinematics/Axis breaks="}));
  Simulation          best(finest, quiet);
  const ResultNumbers of_finest(best.solve());
  std::cout << "LE-4 as the truth, DoFs: " << best.results().n_dofs() << "\n\n";

  csv << "theory,dofs,goal,error,estimate,bar\n";
  ModelCache cache;
  for (const std::string theory : {"EBBT", "TBT", "TE-4", "SV", "SV-6", "LE-2"})
    {
      const Scene poor =
        read_scene(SceneText::read(file, {"Theory=" + theory}));
      Simulation                    simulation(poor, quiet);
      const unsigned int            n_dofs = simulation.solve().n_dofs();
      const std::vector<GoalResult> results =
        Estimation(simulation, quiet, cache).goals();
      for (unsigned int q = 0; q < results.size(); ++q)
        add_goal(theory,
                 n_dofs,
                 results[q],
                 of_finest.value(poor.goals.quantities[q]));
    }
  table.set_precision("value", 5);
  table.write_text(std::cout, dealii::TableHandler::org_mode_table);
}



int
main(int argc, char **argv)
{
  MpiSession mpi(argc, argv);
  return run_and_report([] { BarsOfTheories().run(); });
}
