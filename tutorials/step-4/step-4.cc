// SPDX-License-Identifier: LGPL-2.1-or-later

// step-4: two cubes, and the meaning of a penalty.
//
// Two cubes are pressed on each other. The contact force is known to the last
// digit, so every error can be seen: that of the penalty, which falls with it,
// and that of the arithmetic, which grows. The program computes the force with
// penalties over twenty decades in three ways, draws the U that the errors
// make, and marks where two formulas for the best penalty put it. See README.md
// in this folder.

#include <lamella/axis/axis.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/body/beam.h>
#include <lamella/contact/gap_constraints.h>
#include <lamella/section/theory.h>
#include <lamella/shape/shapes.h>
#include <lamella/solve/checks.h>
#include <lamella/solve/nonlinear_solver.h>

#include <deal.II/base/table_handler.h>

#include <fstream>
#include <iomanip>
#include <iostream>
#include <limits>

using namespace lamella;
using dealii::Point;

class TwoCubes
{
public:
  TwoCubes();
  void
  run();

private:
  std::vector<GapConstraint>
  gap_constraints(const double penalty) const;
  double
  relative_error(const std::vector<GapConstraint> &rows,
                 const std::vector<double>        &force) const;
  double
  solved_once(const std::vector<GapConstraint> &rows,
              LinearSystem                     &solver) const;
  double
  refined(const std::vector<GapConstraint> &rows, LinearSystem &solver) const;
  void
  measure(const int decade);

  // The scene: cubes, a gap between them, the way down of the upper face.
  static constexpr double side = 1., modulus = 200., gap = 0.01, down = 0.03;
  // Without a penalty the cubes are two springs E / side in series, per area.
  static constexpr double stiffness = modulus / (2. * side),
                          force     = stiffness * (down - gap) * side * side;

  // What a way of computing returns where it says that it cannot go.
  static constexpr double not_found = std::numeric_limits<double>::quiet_NaN();

  ContactPair                faces;
  std::unique_ptr<Structure> structure;
  ContactInterface           interface;

  dealii::TableHandler table;
  std::ofstream        csv{"step-4.csv"};
};



// Poisson's ratio is zero, so each cube is in uniform compression and nothing
// but the penalty and the arithmetic can be wrong. The faces look at each other
// node by node: the bottom of the upper one, z = side + gap, and the top of the
// lower one.
TwoCubes::TwoCubes()
{
  const Laminate one_ply{side, {0.}, {side}, {"solid"}, {2}, {2}};
  const auto     section =
    make_section(make_section_mesh(
                   one_ply,
                   {{"solid", EngineeringConstants::isotropic(modulus, 0.)}}),
                 Theory::parse({"Theory", "LE-2"}));
  AxisMesh mesh;
  mesh.length     = side;
  mesh.elements   = {2};
  const auto axis = std::make_shared<Axis>(mesh);

  Bodies    bodies;
  Placement above;
  above.origin = Point<3>(0., 0., side + gap);
  bodies.push_back(std::make_unique<Beam>("upper", section, axis, above));
  bodies.push_back(std::make_unique<Beam>("lower", section, axis, Placement()));

  faces.name           = "faces";
  faces.first          = {0, Region::Kind::surface, "bottom", {}};
  faces.second         = {1, Region::Kind::surface, "top", {}};
  faces.discretization = Discretization::node_to_node;
  faces.enforcement    = Enforcement::penalty;
  faces.overclosure    = Overclosure::resolve;
  faces.penalty        = {PenaltyKind::per_area, 1.};
  interface            = make_interface(faces, bodies);

  const Support press{"press",
                      {{0, Region::Kind::surface, "top", {}}},
                      {{0., 0., -down}}},
    floor{"floor", {{1, Region::Kind::surface, "bottom", {}}}, {{0., 0., 0.}}};
  structure = std::make_unique<Structure>(std::move(bodies),
                                          std::vector<Support>{press, floor},
                                          std::vector<Load>());
}



// The same rows with another penalty: per area, so that all rows together are
// one spring @p penalty * side^2.
std::vector<GapConstraint>
TwoCubes::gap_constraints(const double penalty) const
{
  std::vector<GapConstraint> rows = interface.rows;
  for (unsigned int k = 0; k < rows.size(); ++k)
    rows[k].penalty = penalty * interface.points[k].area;
  return rows;
}



double
TwoCubes::relative_error(const std::vector<GapConstraint> &rows,
                         const std::vector<double>        &forces) const
{
  double sum = 0.;
  for (unsigned int k = 0; k < rows.size(); ++k)
    sum += forces[k];
  return sum / force - 1.;
}



// The paper's Eq. 22 taken at its word: all rows touch, (K + K^p) u = F -
// B^T eps g_init is solved once, and the forces are eps times the penetrations
// that come out (Eq. 25). Beyond 1e15 the sum may have lost its positive
// definiteness, too; whether it has depends on the rounding of the processor's
// own BLAS, and so says nothing but that the sum cannot be used there.
double
TwoCubes::solved_once(const std::vector<GapConstraint> &rows,
                      LinearSystem                     &solver) const
{
  try
    {
      const BlockVector         u = solver.solve_free(1.).u;
      std::vector<unsigned int> all(rows.size());
      Vector                    minus_gap(rows.size());
      for (unsigned int k = 0; k < rows.size(); ++k)
        {
          all[k]       = k;
          minus_gap[k] = -rows[k].gap(u, 1.);
        }
      BlockVector du;
      Vector      forces;
      solver.solve_linear(all, structure->zero(), minus_gap, du, forces);
      return relative_error(rows,
                            std::vector<double>(forces.begin(), forces.end()));
    }
  catch (const NumericsError &)
    {
      return not_found;
    }
}



// What a run of Lamella does: it finds the rows that touch by itself, refines
// against the equilibrium of the strains and the contact law, and checks that
// both hold in the end.
double
TwoCubes::refined(const std::vector<GapConstraint> &rows,
                  LinearSystem                     &solver) const
{
  try
    {
      const State      state   = NonlinearSolver(solver).solve(1.).state;
      ContactInterface contact = interface;
      contact.rows             = rows;
      check_solution(state,
                     check_state(solver.tangent(), {contact}, 2, state, 1.),
                     1.);
      return relative_error(rows, state.force);
    }
  catch (const NumericsError &)
    {
      return not_found;
    }
}



void
TwoCubes::measure(const int decade)
{
  const double                     ratio = std::pow(10., decade);
  const std::vector<GapConstraint> rows  = gap_constraints(ratio * stiffness);
  LinearSystem                     full(linearized_without_solvers(*structure),
                    rows,
                    {},
                    Strategy::full);
  LinearSystem                     condensed(linearized(*structure), rows);

  // Springs in series: a penalty of its own gives F (1 / (1 + k / eps)).
  const double by_design = -1. / (1. + ratio), once = solved_once(rows, full),
               again = refined(rows, full), small = refined(rows, condensed);
  csv << std::setprecision(17) << ratio << "," << by_design << "," << once
      << "," << again << "," << small << "\n";
  table.add_value("eps / k", "1e" + std::to_string(decade));
  for (const auto &[name, value] : {std::make_pair("by design", by_design),
                                    std::make_pair("K + K^p once", once),
                                    std::make_pair("full", again),
                                    std::make_pair("condensed", small)})
    {
      table.add_value(name, value);
      table.set_precision(name, 3);
      table.set_scientific(name, true);
    }
}



// k balances rounding t, N unknowns: eps N t / k = k / eps, hence
// k / sqrt(N t) (Nour-Omid and Wriggers); the paper prints k / (sqrt(N) t).
void
TwoCubes::run()
{
  csv << "ratio,by_design,once,full,condensed\n";
  for (int decade = -4; decade <= 16; ++decade)
    measure(decade);
  table.write_text(std::cout, dealii::TableHandler::org_mode_table);

  const double n = structure->n_dofs(),
               t = std::numeric_limits<double>::epsilon();
  std::cout << "DoFs: " << structure->n_dofs()
            << "\nbest penalty over k, Nour-Omid and Wriggers: "
            << 1. / std::sqrt(n * t)
            << "\nbest penalty over k, as printed: " << 1. / (std::sqrt(n) * t)
            << "\nautomatic penalty over k: "
            << 1e6 * modulus * 2. / side / stiffness << std::endl;
}



int
main(int argc, char **argv)
{
  // Trilinos wants MPI, for one process too.
  MpiSession mpi(argc, argv);
  return run_and_report([] { TwoCubes().run(); });
}
