// SPDX-License-Identifier: LGPL-2.1-or-later

// step-0: a layer-wise beam that meets two stops.
//
// A [0/90/0] cantilever is loaded at its tip, below whose two corners stand
// rigid stops at a small distance. The program builds one beam, two gap rows
// and the Newton loop of the paper, with K + K^p, from the library's pieces.
// What it finds can be held against beam theory: with the tip lying on the
// stops,
//
//   R = F - 3 EI g / L^3
//
// is what they carry together. See README.md in this folder.

// A beam is a section times an axis; each has its own room in the library.
#include <lamella/axis/axis.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/body/beam.h>
#include <lamella/body/body_solver.h>
#include <lamella/conditions/load.h>
#include <lamella/conditions/row_reduction.h>
#include <lamella/contact/gap_constraints.h>
#include <lamella/linear/factorization.h>
#include <lamella/material/material.h>
#include <lamella/shape/shapes.h>

#include <algorithm>
#include <fstream>
#include <iostream>

using namespace lamella;
using dealii::Point;

class StoppedCantilever
{
public:
  StoppedCantilever();
  void
  run();

private:
  void
  make_gap_constraints();
  UpperTriangle
  stiffness_with_penalty(const std::vector<unsigned int> &active) const;
  void
  report(const BlockVector &u) const;

  // The scene, in meters and newtons.
  static constexpr double length = 1., width = 0.05, thickness = 0.006,
                          force = 20., stop_gap = 0.01, penalty = 1e9;
  const Laminate  laminate{width,
                          {0., 90., 0.},
                          std::vector<double>(3, thickness / 3.),
                          std::vector<std::string>(3, "ply"),
                          /*cells_per_ply=*/{1},
                          /*cells_across=*/{2}};
  const Materials materials{{"ply", library_material("IM7-8552", Units())}};

  // Its discretization: bodies, what holds them, what loads them, what they may
  // touch.
  Bodies                        bodies;
  std::unique_ptr<RowReduction> supports;
  BlockVector                   load;
  std::vector<GapConstraint>    gaps;

  std::unique_ptr<StiffnessMatrix> stiffness;
};



// The section is meshed once, with one cell a ply through the thickness, and
// dressed with the expansion: LE-2, nine-node Lagrange cells. deal.II manages
// the section mesh and, separately, the mesh of the axis: eight cubic elements.
StoppedCantilever::StoppedCantilever()
{
  const auto section = make_section(make_section_mesh(laminate, materials),
                                    Theory::parse({"Theory", "LE-2"}));
  AxisMesh   axis;
  axis.length   = length;
  axis.elements = {8};
  bodies.push_back(std::make_unique<Beam>(
    "cantilever", section, std::make_shared<Axis>(axis), Placement()));

  // A support is a set of rows, the displacements of points, with values. Rows
  // may depend on each other; the reduction eliminates as many DoFs as there
  // are independent rows, and keeps the result as deal.II's AffineConstraints.
  const Support clamp{"clamp",
                      {{0, Region::Kind::surface, "start", {}}},
                      {{0., 0., 0.}}};
  supports =
    std::make_unique<RowReduction>(*bodies[0],
                                   0,
                                   prescribed_functionals({clamp}, bodies),
                                   std::vector<std::string>{"clamp"});

  // A load is rows, too, on the right-hand side: here a force per length along
  // the upper edge of the tip.
  const Point<3> left(0., length, thickness), right(width, length, thickness);
  const Load     tip{"tip",
                 {{0, Region::Kind::line, "", {left, right}}},
                 {{0., 0., -force / width}},
                 ""};
  load.reinit(1, bodies[0]->n_dofs());
  add_load(tip, bodies, load);
}



// And so is contact. The gap of Eq. 16 is n . (u_2 - u_1) + g_init with the
// outward normal n of the first body; the second one, a rigid stop, does not
// move, so it has no part in the row. With n = (0, 0, -1) the row is u_z
// of the corner, plus the initial gap.
void
StoppedCantilever::make_gap_constraints()
{
  const std::vector<Location> corners =
    locate_all(*bodies[0], {{0., length, 0.}, {width, length, 0.}}, "stops");
  for (const std::vector<LinearFunctional> &u :
       bodies[0]->rows(corners, undisplaced))
    {
      GapConstraint row;
      row.parts       = {{0, u[2]}};
      row.initial_gap = stop_gap;
      row.penalty     = penalty;
      gaps.push_back(row);
    }
}



// K comes from four small matrices of the section and four of the axis, never
// from an integral over the volume. A closed stop adds k^p = eps n^T n (Eq. 23)
// with the gap row in the place of n, of which the supports leave what is free.
UpperTriangle
StoppedCantilever::stiffness_with_penalty(
  const std::vector<unsigned int> &active) const
{
  UpperTriangle matrix;
  stiffness->for_each_entry([&matrix](const DofIndex i,
                                      const DofIndex j,
                                      const double k) { matrix.add(i, j, k); });
  for (const unsigned int r : active)
    {
      const LinearFunctional n =
        gaps[r].parts[0].row.reduced(supports->constraints());
      for (const auto &[i, n_i] : n.entries())
        for (const auto &[j, n_j] : n.entries())
          matrix.add(i, j, gaps[r].penalty * n_i * n_j);
    }
  return matrix;
}



// The Newton loop. The body is linear, so the only unknown is which stops are
// closed: solve for those that are thought to be, look at the gaps, repeat. In
// total form (K + K^p) u = F - B^T eps g_init over the closed rows.
void
StoppedCantilever::run()
{
  make_gap_constraints();
  stiffness = assembled_stiffness(*bodies[0], supports->constraints());

  BlockVector               u(1, bodies[0]->n_dofs());
  std::vector<unsigned int> active, previous;
  unsigned int              iteration = 0;
  do
    {
      u = load;
      for (const unsigned int r : active)
        gaps[r].add_to(u, -gaps[r].penalty * gaps[r].initial_gap);
      supports->constraints().condense(u.block(0));
      factorize_shared(bodies[0]->n_dofs(),
                       stiffness_with_penalty(active),
                       "the cantilever")
        ->solve(u.block(0));
      supports->constraints().distribute(u.block(0));

      previous = active;
      active.clear();
      for (unsigned int r = 0; r < gaps.size(); ++r)
        if (gaps[r].gap(u, 1.) < 0.)
          active.push_back(r);
      std::cout << "iteration " << ++iteration << ": " << active.size()
                << " of " << gaps.size() << " stops closed" << std::endl;
    }
  while (active != previous);
  report(u);
}



// The forces follow from the penetrations (Eq. 25). Points of the body are
// located once and then asked for anything; here the deflection along the
// middle of the upper face.
void
StoppedCantilever::report(const BlockVector &u) const
{
  double carried = 0.;
  for (const GapConstraint &row : gaps)
    carried += row.penalty * std::max(0., -row.gap(u, 1.));
  const double EI     = laminate_stiffness(laminate.plies(materials), width).EI;
  const double theory = force - 3. * EI * stop_gap / std::pow(length, 3);
  std::cout.precision(8);
  std::cout << "DoFs: " << bodies[0]->n_dofs() << "\nstop force: " << carried
            << "\nbeam theory: " << theory << "\nratio: " << carried / theory
            << std::endl;

  std::ofstream csv("step-0.csv");
  csv << "y,uz\n";
  for (double y = 0.; y < length + 1e-9; y += 0.02 * length)
    {
      const auto where =
        locate_all(*bodies[0],
                   {{0.5 * width, std::min(y, length), thickness}},
                   "deflection");
      csv << y << "," << bodies[0]->sample(where[0], u.block(0)).displacement[2]
          << "\n";
    }
}



int
main(int argc, char **argv)
{
  // The axis is shared among processes, so there is MPI, for one, too.
  MpiSession mpi(argc, argv);
  return run_and_report([] { StoppedCantilever().run(); });
}
