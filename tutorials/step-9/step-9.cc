// SPDX-License-Identifier: LGPL-2.1-or-later

// step-9: the dual of a goal.
//
// A short laminated cantilever carries a force across its top, and three
// numbers are wanted of it. How far off is each of them in a given theory, and
// where does the error come from? The program looks at the *dual* of a number,
// the displacement of the same beam under the number as a load, and finds two
// identities. Error bars stand on the second one (step-16). See README.md in
// this folder.

#include "../cantilever.h"

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>

#include <deal.II/base/table_handler.h>

#include <fstream>
#include <iostream>
#include <map>

using namespace lamella;

namespace
{
  // What is asked of the beam: a component of the displacement or the stress
  // (order xx, yy, zz, xy, xz, yz) at one of the scene's three probes.
  struct Goal
  {
    std::string  name;
    unsigned int probe;
    Quantity     quantity;
    unsigned int component;
  };
  const std::vector<Goal> goals{{"tip: uz", 0, Quantity::displacement, 2},
                                {"outer: syy", 1, Quantity::stress, 1},
                                {"inner: syz", 2, Quantity::stress, 5}};
} // namespace



class DualsOfGoals
{
public:
  DualsOfGoals();
  void
  run();

private:
  LinearFunctional
  functional(const Goal &goal, const Structure &structure) const;
  Vector
  dual(const Goal &goal, const Model &model) const;

  void
  print_duals();
  void
  add_error(const std::string &name, const Model &poor, const Goal &goal);

  const Cantilever              beam;
  const Model                   rich;
  std::map<std::string, Vector> duals;

  dealii::TableHandler errors;
  std::ofstream pictures{"step-9-fields.csv"}, shares{"step-9-shares.csv"};
};



// The section has the functions of LE-3 and the Saint-Venant warpings beside
// them: in this one space live the theories LE-1, LE-2, LE-3 and SV, each a
// list of fields, as in step-8. The richest of them stands for the truth, for
// the moment. The axis is fine where stresses are asked for, since duals are
// rough there.
DualsOfGoals::DualsOfGoals()
  : beam(STEP_9_SCENE)
  , rich(beam.solved(beam.layer_wise(3)))
{}



// The goal as a functional J of the beam's DoFs. Whatever can be said of a body
// is a LinearFunctional, a list of DoFs with weights: J(u) = sum j_k u_k.
LinearFunctional
DualsOfGoals::functional(const Goal &goal, const Structure &structure) const
{
  const Body &body  = *structure.bodies()[0];
  const auto  place = beam.scene.probes[goal.probe].position;
  return body.rows({locate_all(body, {place}, "probe")[0]},
                   undisplaced,
                   goal.quantity)[0][goal.component];
}



// The idea of this step. Read the row as a column: the weights j_k are a load
// vector, the load that does work 1 where the goal is 1. For a deflection this
// is a unit force at its place, for a stress a tangle of forces around it that
// cancel. The displacement z under this load,
//
//   K z = j,
//
// is the goal's *dual*. It costs one more solution with the same factors; the
// same supports hold it.
Vector
DualsOfGoals::dual(const Goal &goal, const Model &model) const
{
  BlockVector j = model.structure->zero();
  functional(goal, *model.structure).add_to(j.block(0), 1.);
  return model.factors->solve(j).block(0);
}



// First use. K is symmetric, so J(u) = j . u = z . K u = z . f: the goal is the
// work of the load on the dual (Betti and Maxwell). Without solving for u again
// this holds for each load, wherever it stands: z_z along the axis is the
// *influence line* of the goal, as bridge builders draw it.
void
DualsOfGoals::print_duals()
{
  dealii::TableHandler table;
  const Vector         f = rich.structure->load(1.).block(0);
  for (const Goal &goal : goals)
    {
      const double  value = functional(goal, *rich.structure)(rich.u);
      const Vector &z = duals[goal.name] = dual(goal, rich);
      table.add_value("goal", goal.name);
      table.add_value("value", value);
      table.add_value("load on dual", f * z);
      table.add_value("ratio", f * z / value);
      Cantilever::draw(pictures, goal.name, *rich.structure->bodies()[0], z);
    }
  table.set_precision("value", 6);
  table.set_precision("load on dual", 6);
  table.set_precision("ratio", 8);
  std::cout << "LE-3 as the truth, DoFs: " << rich.u.size() << "\n\n";
  table.write_text(std::cout, dealii::TableHandler::org_mode_table);
}



// Second use, and the reason for all of it. Let u_H be what a poor theory finds
// and r = f - K u_H the forces that it leaves unbalanced in the rich space.
// Then
//
//   J(u) - J(u_H) = j . (u - u_H) = z . K (u - u_H) = z . r:
//
// the error of the goal is the residual, weighted with the dual. Wherever one
// of the two is small nothing is lost, however wrong the other. And since the
// poor theory has done its best, r does no work on anything that it can do
// itself, such as its own dual z_H: what counts of z is only what the poor
// space does not have, z - z_H.
//
// Node by node z . r says where the error comes from.
void
DualsOfGoals::add_error(const std::string &name,
                        const Model       &poor,
                        const Goal        &goal)
{
  BlockVector u                = rich.structure->zero();
  u.block(0)                   = beam.embedded(poor.u, poor.list);
  const Vector           r     = rich.structure->residual(u, 1.).block(0);
  const Vector          &z     = duals.at(goal.name);
  const Vector           z_H   = beam.embedded(dual(goal, poor), poor.list);
  const LinearFunctional J     = functional(goal, *rich.structure);
  const double           truth = J(rich.u), error = truth - J(u.block(0));

  errors.add_value("goal, theory", goal.name + ", " + name);
  errors.add_value("DoFs", poor.u.size());
  errors.add_value("value", J(u.block(0)));
  errors.add_value("error", error);
  errors.add_value("residual on dual", r * z);
  errors.add_value("ratio", r * z / error);
  errors.add_value("on its own dual", (r * z_H) / truth);

  const unsigned int n = beam.section->n_fields();
  for (unsigned int node = 0; node < beam.axis->n_nodes(); ++node)
    {
      double share = 0.;
      for (unsigned int k = node * n; k < (node + 1) * n; ++k)
        share += r[k] * z[k];
      shares << name << "," << goal.name << "," << beam.axis->nodes()[node]
             << "," << share / truth << "\n";
    }
}



void
DualsOfGoals::run()
{
  pictures << "field,y,z,uy,uz\n";
  shares << "theory,goal,y,share\n";
  Cantilever::draw(pictures, "primal", *rich.structure->bodies()[0], rich.u);
  print_duals();

  const Model sv   = beam.solved(beam.saint_venant()),
              le_1 = beam.solved(beam.layer_wise(1)),
              le_2 = beam.solved(beam.layer_wise(2));
  for (const Goal &goal : goals)
    {
      add_error("SV", sv, goal);
      add_error("LE-1", le_1, goal);
      add_error("LE-2", le_2, goal);
    }
  for (const char *column : {"value", "error", "residual on dual", "ratio"})
    errors.set_precision(column, 6);
  errors.set_precision("on its own dual", 1);
  errors.set_scientific("on its own dual", true);
  std::cout << "\n";
  errors.write_text(std::cout, dealii::TableHandler::org_mode_table);
}



int
main(int argc, char **argv)
{
  // The axis is shared among processes, so there is MPI, for one, too.
  MpiSession mpi(argc, argv);
  return run_and_report([] { DualsOfGoals().run(); });
}
