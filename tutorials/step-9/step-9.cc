// SPDX-License-Identifier: LGPL-2.1-or-later

// step-9: an error bar.
//
// A short laminated cantilever carries a force across its top, and three
// numbers are wanted of it. How far off is each of them in a given theory? The
// first half of the program looks at where the error of one number, a goal,
// comes from: at its dual, the displacement of the same beam under the goal as
// a load. The second half has error bars made for six theories by the library
// and holds them against the true errors. See README.md in this folder.

#include <lamella/base/exceptions.h>
#include <lamella/base/mpi_session.h>
#include <lamella/base/text.h>
#include <lamella/body/beam.h>
#include <lamella/estimate/estimation.h>
#include <lamella/section/saint_venant.h>
#include <lamella/section/warping.h>
#include <lamella/solve/contact_solver.h>
#include <lamella/solve/structure.h>

#include <deal.II/base/table_handler.h>

#include <fstream>
#include <iostream>
#include <numeric>

using namespace lamella;
using dealii::Point;

namespace
{
  // What is asked of the beam: a component of the displacement or the stress
  // (order xx, yy, zz, xy, xz, yz) at one of the scene's probes.
  struct Goal
  {
    std::string  name, probe;
    Quantity     quantity;
    unsigned int component;
  };
  const std::vector<Goal> goals{{"tip: uz", "tip", Quantity::displacement, 2},
                                {"outer: syy", "outer", Quantity::stress, 1},
                                {"inner: syz", "inner", Quantity::stress, 5}};

  // The fields that a node carries, by their numbers.
  using List = std::vector<unsigned int>;

  // The stiffness of a structure at a state, with its factors.
  using Tangent = std::shared_ptr<const Linearisation>;
} // namespace



class CantileverWithBars
{
public:
  CantileverWithBars();
  void
  run();

private:
  // Lists of fields: poor ones, and the rich one that stands for the truth.
  List
  saint_venant() const;
  List
  layer_wise(const unsigned int degree) const;

  std::unique_ptr<Structure>
  structure(const List &list) const;
  Vector
  primal(const Tangent &tangent) const;
  Row
  functional(const Structure &structure, const Goal &goal) const;
  Vector
  dual(const Tangent &tangent, const Goal &goal) const;
  Vector
  embedded(const Vector &u, const List &list) const;

  void
  print_duals();
  void
  print_error(const std::string &name, const List &list, const Goal &goal);
  void
  draw(const std::string &name, const Vector &u);

  void
  compare_theories() const;

  static constexpr const char *file = STEP_9_SCENE;

  const Scene                        scene;
  std::shared_ptr<const SectionMesh> mesh;
  std::shared_ptr<const Section>     section;
  std::shared_ptr<const FieldSpace>  space;
  std::shared_ptr<const Axis>        axis;
  std::unique_ptr<Structure>         rich;
  Tangent                            tangent;
  std::map<std::string, Vector>      duals;
  Vector                             truth;

  dealii::TableHandler errors;
  std::ofstream pictures{"step-9-fields.csv"}, shares{"step-9-shares.csv"};
};



// The beam is the scene's, but for two things. Its section has the functions of
// LE-3, hierarchical by degree, with the six Saint-Venant warpings beside them:
// in this one space live the theories LE-1, LE-2, LE-3 and SV, each a list of
// fields, so that what one of them finds can be said in the words of another,
// exactly. And the axis is finer where the stresses are asked for, since duals
// are rough there.
CantileverWithBars::CantileverWithBars()
  : scene(read_scene(SceneText::read(file, {})))
  , mesh(build_section_meshes(scene).at("strip"))
{
  Theory theory       = Theory::parse({"Theory", "LE-3"});
  theory.hierarchical = true;
  section             = make_section(mesh, theory);

  const SaintVenant states(*section);
  const Warping     warping(*section);
  space = std::make_shared<FieldSpace>(section,
                                       saint_venant_warpings(states, warping));

  AxisMesh description = scene.bodies[0].axis;
  description.breaks   = {3., 7., 9., 11., 13., 20.};
  description.elements = {2, 2, 2, 4, 2, 3, 4};
  axis                 = std::make_shared<Axis>(description);
  rich                 = structure(layer_wise(3));
  tangent              = linearised(*rich);
  truth                = primal(tangent);
}



// Six rigid motions of the section and six warpings.
List
CantileverWithBars::saint_venant() const
{
  List list(6 + space->n_modes());
  std::iota(list.begin(), list.begin() + 6, 0);
  std::iota(list.begin() + 6, list.end(), space->first_mode());
  return list;
}



// LE of @p degree: the fields of the section up to this degree.
List
CantileverWithBars::layer_wise(const unsigned int degree) const
{
  List list;
  for (unsigned int alpha = 0; alpha < section->n_fields(); ++alpha)
    if (section->field_degree(alpha) <= degree)
      list.push_back(alpha);
  return list;
}



// A beam all of whose nodes carry @p list, with the scene's clamp and load.
std::unique_ptr<Structure>
CantileverWithBars::structure(const List &list) const
{
  Bodies bodies;
  bodies.push_back(
    std::make_unique<Beam>("beam",
                           space,
                           axis,
                           scene.bodies[0].placement,
                           std::vector<List>(axis->n_nodes(), list),
                           "a list"));
  return std::make_unique<Structure>(std::move(bodies),
                                     scene.supports,
                                     scene.loads);
}



// What every run computes: K u = f.
Vector
CantileverWithBars::primal(const Tangent &tangent) const
{
  const std::vector<GapRow> no_rows;
  return ContactSolver(tangent, no_rows).solve_free(1.).u.block(0);
}



// The goal as a functional J of the beam's DoFs. Whatever can be said of a body
// is a Row, a list of DoFs with weights: J(u) = sum j_k u_k.
Row
CantileverWithBars::functional(const Structure &structure,
                               const Goal      &goal) const
{
  const Body &body = *structure.bodies()[0];
  for (const Probe &probe : scene.probes)
    if (probe.name == goal.probe)
      return body.rows({locate_all(body, {probe.position}, "probe")[0]},
                       goal.quantity)[0][goal.component];
  throw InputError("no probe '" + goal.probe + "'.");
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
CantileverWithBars::dual(const Tangent &tangent, const Goal &goal) const
{
  BlockVector j = tangent->of().zero();
  functional(tangent->of(), goal).add_to(j.block(0), 1.);
  return tangent->solve(j).block(0);
}



// First use. K is symmetric, so J(u) = j . u = z . K u = z . f: the goal is the
// work of the load on the dual (Betti and Maxwell). Without solving for u again
// this holds for each load, wherever it stands: z_z along the axis is the
// *influence line* of the goal, as bridge builders draw it.
void
CantileverWithBars::print_duals()
{
  dealii::TableHandler table;
  for (const Goal &goal : goals)
    {
      const double value = functional(*rich, goal)(truth);
      duals[goal.name]   = dual(tangent, goal);
      const Vector &z    = duals[goal.name];
      table.add_value("goal", goal.name);
      table.add_value("value", value);
      table.add_value("load on dual", rich->load().block(0) * z);
      table.add_value("ratio", rich->load().block(0) * z / value);
    }
  for (const char *column : {"value", "load on dual"})
    table.set_precision(column, 6);
  table.set_precision("ratio", 8);
  std::cout << "LE-3 as the truth, DoFs: " << rich->n_dofs() << "\n\n";
  table.write_text(std::cout, dealii::TableHandler::org_mode_table);
}



// A displacement of a beam with @p list in the DoFs of the rich one. Node by
// node: a field of the section is itself there, a mode is a combination.
Vector
CantileverWithBars::embedded(const Vector &u, const List &list) const
{
  const unsigned int n = section->n_fields();
  Vector             result(axis->n_nodes() * n);
  for (unsigned int k = 0; k < list.size(); ++k)
    {
      const Vector field = space->in_section_fields(list[k]);
      for (unsigned int node = 0; node < axis->n_nodes(); ++node)
        for (unsigned int alpha = 0; alpha < n; ++alpha)
          result[node * n + alpha] += u[node * list.size() + k] * field[alpha];
    }
  return result;
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
CantileverWithBars::print_error(const std::string &name,
                                const List        &list,
                                const Goal        &goal)
{
  const auto  poor    = structure(list);
  const auto  factors = linearised(*poor);
  BlockVector u       = rich->zero();
  u.block(0)          = embedded(primal(factors), list);
  const Vector  r     = rich->residual(u, 1.).block(0);
  const Vector &z     = duals.at(goal.name);
  const Vector  z_H   = embedded(dual(factors, goal), list);
  const Row     J     = functional(*rich, goal);
  const double  error = J(truth) - J(u.block(0));

  errors.add_value("goal, theory", goal.name + ", " + name);
  errors.add_value("DoFs", poor->n_dofs());
  errors.add_value("value", J(u.block(0)));
  errors.add_value("error", error);
  errors.add_value("residual on dual", r * z);
  errors.add_value("ratio", r * z / error);
  errors.add_value("on its own dual", (r * z_H) / J(truth));

  const unsigned int n = section->n_fields();
  for (unsigned int node = 0; node < axis->n_nodes(); ++node)
    {
      double share = 0.;
      for (unsigned int k = node * n; k < (node + 1) * n; ++k)
        share += r[k] * z[k];
      shares << name << "," << goal.name << "," << axis->nodes()[node] << ","
             << share / J(truth) << "\n";
    }
}



// A displacement on a grid of the section x = 1.5 along the beam, for plot.py.
void
CantileverWithBars::draw(const std::string &name, const Vector &u)
{
  constexpr unsigned int along = 120, up = 12;
  constexpr double       x    = 1.5;
  const Body            &body = *rich->bodies()[0];
  const double height = section->element().bounding_box().side_length(1);
  for (unsigned int j = 0; j <= up; ++j)
    for (unsigned int i = 0; i <= along; ++i)
      {
        const Point<3> place(x, axis->length() * i / along, height * j / up);
        const auto     location = locate_all(body, {place}, "pictures")[0];
        const auto     moved    = body.sample(location, u).displacement;
        pictures << name << "," << place[1] << "," << place[2] << ","
                 << moved[1] << "," << moved[2] << "\n";
      }
}



// What remains is to know z and the truth, which nobody does: both would take
// the rich model. So a bar solves richer models of the same scene, twice, and
// looks whether they agree (doc/error-bars.md). Estimation does that for a
// Simulation. Models that several theories have in common are solved once,
// since they share a cache. The true errors are those to LE-4 on a finer axis
// with more cells across.
void
CantileverWithBars::compare_theories() const
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
  std::cout << "\nLE-4 as the truth, DoFs: " << best.results().n_dofs()
            << "\n\n";

  ModelCache           cache;
  dealii::TableHandler table;
  std::ofstream        csv("step-9-bars.csv");
  csv << "theory,dofs,goal,error,estimate,bar\n";
  for (const std::string theory : {"EBBT", "TBT", "TE-4", "SV", "SV-6", "LE-2"})
    {
      const Scene poor =
        read_scene(SceneText::read(file, {"Theory=" + theory}));
      Simulation                    simulation(poor, quiet);
      const unsigned int            n_dofs = simulation.solve().n_dofs();
      const std::vector<GoalResult> results =
        Estimation(simulation, quiet, cache).goals();
      for (unsigned int q = 0; q < results.size(); ++q)
        {
          const GoalResult &goal  = results[q];
          const double true_value = of_finest.value(poor.goals.quantities[q]);
          const double error      = (true_value - goal.value) / goal.scale;
          table.add_value("theory, goal", theory + ", " + goal.name);
          table.add_value("DoFs", n_dofs);
          table.add_value("value", goal.value);
          table.add_value("error, %", to_text(100. * error, 3));
          table.add_value("estimated, %",
                          to_text(100. * goal.estimate / goal.scale, 3));
          table.add_value("bar, %",
                          goal.trusted ?
                            to_text(100. * goal.bar / goal.scale, 3) :
                            "none yet");
          table.add_value("error over bar",
                          goal.trusted ?
                            to_text(std::abs(error) * goal.scale / goal.bar,
                                    2) :
                            "");
          csv << theory << "," << n_dofs << "," << goal.name << "," << error
              << "," << goal.estimate / goal.scale << ","
              << (goal.trusted ? to_text(goal.bar / goal.scale, 6) : "")
              << "\n";
        }
    }
  table.set_precision("value", 5);
  table.write_text(std::cout, dealii::TableHandler::org_mode_table);
}



void
CantileverWithBars::run()
{
  print_duals();

  shares << "theory,goal,y,share\n";
  for (const Goal &goal : goals)
    {
      print_error("SV", saint_venant(), goal);
      print_error("LE-1", layer_wise(1), goal);
      print_error("LE-2", layer_wise(2), goal);
    }
  for (const char *column : {"value", "error", "residual on dual"})
    errors.set_precision(column, 6);
  errors.set_precision("ratio", 6);
  errors.set_precision("on its own dual", 1);
  errors.set_scientific("on its own dual", true);
  std::cout << "\n";
  errors.write_text(std::cout, dealii::TableHandler::org_mode_table);

  pictures << "field,y,z,uy,uz\n";
  draw("primal", truth);
  for (const Goal &goal : goals)
    draw(goal.name, duals.at(goal.name));

  compare_theories();
}



int
main(int argc, char **argv)
{
  // The axis is shared among processes, so there is MPI, for one, too.
  MpiSession mpi(argc, argv);
  return run_and_tell([] { CantileverWithBars().run(); });
}
