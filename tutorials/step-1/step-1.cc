// SPDX-License-Identifier: LGPL-2.1-or-later

// step-1: a cantilever in five theories.
//
// A square cantilever is lifted by a force at its tip. The program computes it
// with the theory of Euler and Bernoulli, with that of Timoshenko, with two
// Taylor expansions and with layer-wise Lagrange elements, in one loop: what
// changes from one to the next is the list of functions over the section and
// nothing else. Two more runs show what a section loses that cannot contract,
// and an axis without a fine mesh at the clamp. See README.md in this folder.

#include <lamella/axis/axis.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/body/beam.h>
#include <lamella/section/theory.h>
#include <lamella/shape/shapes.h>
#include <lamella/solve/linear_system.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/table_handler.h>

#include <fstream>
#include <iostream>

using namespace lamella;
using dealii::Point;

class FiveTheories
{
public:
  FiveTheories();
  void
  run();

private:
  void
  compute(const std::string                 &name,
          const Theory                      &theory,
          const std::shared_ptr<const Axis> &axis);
  void
  solve();
  double
  sigma_yz(const double x, const double z) const;
  double
  mean_sigma_yz(const double z) const;
  void
  report(const std::string &name);

  // The scene, in meters and newtons.
  static constexpr double length = 1., width = 0.1, height = 0.1, force = 1000.,
                          modulus = 70e9, poisson = 0.3;
  static constexpr double area    = width * height,
                          inertia = width * height * height * height / 12.;

  // What all theories share: the mesh of the section and the axis.
  std::shared_ptr<const SectionMesh> section_mesh;
  std::shared_ptr<const Axis>        graded_axis, equal_axis;

  // The beam of the theory at hand, held and loaded, and its displacements.
  std::unique_ptr<Structure> structure;
  Vector                     u;

  dealii::TableHandler table;
  std::ofstream        profiles{"step-1.csv"};
};



// A beam of one material is a laminate of one ply. Its section has 2 x 2 cells:
// the Lagrange theories put their nodes there. The Taylor expansions and the
// classical theories, which know no cells, only integrate over them.
//
// The axis is finer at the clamp. The clamp holds the whole section, which
// elsewhere contracts and bends across under sigma_yy. In theories that know
// contraction this disturbance dies out within about one height of the section
// (Saint-Venant); beyond it the solution is a cubic along y, and so is a B4. So
// half of the eight elements go to the first two heights, half of these to the
// first half height. For comparison, eight equal elements.
FiveTheories::FiveTheories()
{
  const Laminate laminate{
    width, {0.}, {height}, {"aluminium"}, /*cells_per_ply=*/{2}, {2}};
  section_mesh =
    make_section_mesh(laminate,
                      {{"aluminium",
                        EngineeringConstants::isotropic(modulus, poisson)}});

  AxisMesh mesh;
  mesh.length   = length;
  mesh.elements = {8};
  equal_axis    = std::make_shared<Axis>(mesh);
  mesh.breaks   = {0.5 * height, 2. * height};
  mesh.elements = {2, 2, 4};
  graded_axis   = std::make_shared<Axis>(mesh);
}



// A theory is a choice of functions over the section. In
//
//   u(x, y, z) = sum F_tau(x, z) N_i(y) u_(i,tau)
//
// the names below stand for 1, x, z (EBBT and TBT, with x and z for u_y alone,
// and EBBT with sections that stay normal to the axis), for all polynomials of
// degree 2 or 4 in x and z (TE-2, TE-4), and for Lagrange polynomials of degree
// 3 on each cell of the section (LE-3). All goes through the same matrices, the
// same supports, the same solver and the same sampling of stresses.
void
FiveTheories::run()
{
  profiles << "theory,z,syz\n";
  for (const char *name : {"EBBT", "TBT", "TE-2", "TE-4", "LE-3"})
    compute(name, Theory::parse({"Theory", name}), graded_axis);

  // Plane sections that do not contract strain the material in x and z: with
  // the full Hooke's law the beam has the modulus of a bar in a rigid sleeve,
  // E (1 - nu) / ((1 + nu) (1 - 2 nu)), instead of E. That is Poisson locking.
  // EBBT, TBT and TE-1 therefore let sigma_xx = sigma_zz = 0, unless told not
  // to:
  Theory locked             = Theory::parse({"Theory", "EBBT"});
  locked.poisson_correction = false;
  compute("EBBT locked", locked, graded_axis);

  // The clamp's neighborhood, resolved badly.
  compute("LE-3 equal", Theory::parse({"Theory", "LE-3"}), equal_axis);

  table.set_precision("deflection [m]", 4);
  table.set_scientific("deflection [m]", true);
  table.set_precision("over EBBT", 5);
  table.set_precision("sigma_yy [Pa]", 4);
  table.set_scientific("sigma_yy [Pa]", true);
  table.set_precision("sigma_yz mean", 4);
  table.set_precision("sigma_yz center", 4);
  table.write_text(std::cout, dealii::TableHandler::org_mode_table);
}



// One section, one beam, one structure: in step-0 we held the beam and solved
// for it by hand; Structure does it for any number of bodies.
void
FiveTheories::compute(const std::string                 &name,
                      const Theory                      &theory,
                      const std::shared_ptr<const Axis> &axis)
{
  Bodies bodies;
  bodies.push_back(std::make_unique<Beam>(
    "cantilever", make_section(section_mesh, theory), axis, Placement()));

  const Support clamp{"clamp",
                      {{0, Region::Kind::surface, "start", {}}},
                      {{0., 0., 0.}}};
  const Load    tip{"tip",
                 {{0, Region::Kind::surface, "end", {}}},
                 {{0., 0., force / area}},
                 ""};
  structure = std::make_unique<Structure>(std::move(bodies),
                                          std::vector<Support>{clamp},
                                          std::vector<Load>{tip});
  solve();
  report(name);
}



// Without contact there are no gap rows, and the Newton loop ends after the
// first, linear solution, which it refines against its residual.
void
FiveTheories::solve()
{
  const std::vector<GapConstraint> no_rows;
  u = LinearSystem(linearized(*structure), no_rows).solve_free(1.).u.block(0);
}



// Shear stress at mid-span, as Hooke's law gives it from the strains of the
// theory: nothing is recovered afterwards.
double
FiveTheories::sigma_yz(const double x, const double z) const
{
  const Body    &beam = *structure->bodies()[0];
  const Location where =
    locate_all(beam, {{x, length / 2., z}}, "shear stress")[0];
  return beam.sample(where, u).stress[5];
}



// Its mean over the width is known without any theory. Equilibrium of the part
// above z with sigma_yy, linear in z, gives the parabola
//
//   3/2 F/A (1 - (2 z / h - 1)^2).
//
// What the stress does between left and right is not known from equilibrium
// (README.md).
double
FiveTheories::mean_sigma_yz(const double z) const
{
  const dealii::QIterated<1> quadrature(dealii::QGauss<1>(4), /*cells=*/2);
  double                     mean = 0.;
  for (unsigned int q = 0; q < quadrature.size(); ++q)
    mean += sigma_yz(width * quadrature.point(q)[0], z) * quadrature.weight(q);
  return mean;
}



void
FiveTheories::report(const std::string &name)
{
  const Body &beam   = *structure->bodies()[0];
  const auto  sample = [&](const Point<3> &point) {
    return beam.sample(locate_all(beam, {point}, "results")[0], u);
  };
  const double w =
    sample(Point<3>(width / 2., length, height / 2.)).displacement[2];
  const double euler_bernoulli =
    force * std::pow(length, 3) / (3. * modulus * inertia);

  table.add_value("theory", name);
  table.add_value("DoFs", beam.n_dofs());
  table.add_value("deflection [m]", w);
  table.add_value("over EBBT", w / euler_bernoulli);
  table.add_value("sigma_yy [Pa]",
                  sample(Point<3>(width / 2., length / 2., 0.)).stress[1]);
  // Both over the mean shear stress of the section.
  const double unit = force / area;
  table.add_value("sigma_yz mean", mean_sigma_yz(height / 2.) / unit);
  table.add_value("sigma_yz center", sigma_yz(width / 2., height / 2.) / unit);

  for (unsigned int k = 0; k <= 40; ++k)
    {
      const double z = height * k / 40;
      profiles << name << "," << z << "," << mean_sigma_yz(z) << "\n";
    }
}



int
main(int argc, char **argv)
{
  // The axis is shared among processes, so there is MPI, for one, too.
  MpiSession mpi(argc, argv);
  return run_and_report([] { FiveTheories().run(); });
}
