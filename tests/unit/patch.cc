// SPDX-License-Identifier: LGPL-2.1-or-later

// Patch tests: a displacement u = E x, linear in space, prescribed on the whole
// surface, is the solution inside, with the constant strain E and the stress
// C E, whatever the mesh. Six strain states, sections of one and of several
// plies of the same material, distorted section meshes, all orders, bodies in
// any direction. And rigid motions, which make no strain.

#include "patch_states.h"

#include <lamella/body/body_solver.h>
#include <lamella/shape/shapes.h>

#include <deal.II/grid/grid_tools.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(patch)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const EngineeringConstants
    orthotropic{165., 9., 8., 5.6, 5.2, 2.8, 0.34, 0.3, 0.45};

  /// A section of 3 x 3 cells with its interior vertices moved.
  std::shared_ptr<const SectionMesh>
  distorted_mesh(const double angle)
  {
    const Laminate plies = rectangle(0.7, 0.5, {angle, angle, angle}, 3, 1);
    auto           mesh  = std::make_shared<SectionMesh>();
    const auto regular = make_section_mesh(plies, {{"material", orthotropic}});
    mesh->mesh.copy_triangulation(regular->mesh);
    mesh->plies      = regular->plies;
    mesh->boundaries = regular->boundaries;
    dealii::GridTools::distort_random(0.25, mesh->mesh, true, 7);
    return mesh;
  }
} // namespace

BOOST_AUTO_TEST_CASE(all_orders_one_and_three_plies)
{
  for (const unsigned int section_degree : {1, 2, 3})
    for (const std::vector<double> &angles :
         {std::vector<double>{30.}, std::vector<double>{30., 30., 30.}})
      {
        if (section_degree == 3 && angles.size() == 3)
          continue; // as two plies more of degree 2, at ten times the cost
        const auto section = make_section(rectangle(0.7, 0.5, angles, 2),
                                          orthotropic,
                                          section_degree);
        for (const unsigned int axis_degree :
             {section_degree, 4 - section_degree})
          {
            Beam beam("beam",
                      section,
                      make_axis(1.3, 2, axis_degree),
                      Placement());
            check_patch(beam, section->law(0, {}).stiffness());
          }
      }
}



BOOST_AUTO_TEST_CASE(distorted_section)
{
  for (const unsigned int degree : {1, 2, 3})
    {
      const auto section = make_section(distorted_mesh(20.), degree);
      Beam       beam("beam", section, make_axis(1.3, 2, 2), Placement());
      check_patch(beam, section->law(0, {}).stiffness());
    }
}



BOOST_AUTO_TEST_CASE(other_shapes_of_sections)
{
  // Curved cells, walls around a hole, a mesh by Gmsh (that in degrees 1 and 2:
  // quadrilaterals of degree 3 are in distorted_section, at less cost).
  const OrientedMaterial          oriented_material{"carbon", 20.};
  const Materials                 constants{{"carbon", orthotropic}};
  const std::vector<SectionShape> shapes{
    HalfDisc{0.5, 75., 0.2, 4, oriented_material},
    ThinWalled{ShapeKind::box,
               0.7,
               0.5,
               {0.1, 0.1},
               {0.1, 0.2},
               1,
               1,
               oriented_material},
    SectionFile{std::string(LAMELLA_SOURCE_DIR) + "/prm/sections/hexagon.msh",
                0.05,
                {{"carbon", oriented_material}},
                "Section s"}};
  for (const SectionShape &shape : shapes)
    for (const unsigned int degree : {1, 2, 3})
      {
        if (degree == 3 && std::holds_alternative<SectionFile>(shape))
          continue;
        BOOST_TEST_CONTEXT(name_of(shape))
        {
          const auto section =
            make_section(make_section_mesh(shape, constants), degree);
          Beam beam("beam", section, make_axis(1.3, 2, 1), Placement());
          check_patch(beam, section->law(0, {}).stiffness());
        }
      }
}



BOOST_AUTO_TEST_CASE(taylor_expansions)
{
  // TE-1 with its correction, too: a constant strain leaves nothing for its
  // contraction modes to relax. (TE-3 on a half disc has the
  // polynomial that vanishes on the whole boundary, but on the arc of the mesh,
  // which is interpolated, only in the points that are prescribed.)
  const OrientedMaterial          oriented_material{"carbon", 20.};
  const Materials                 constants{{"carbon", orthotropic}};
  const std::vector<SectionShape> shapes{
    Laminate{0.7, {20.}, {0.5}, {"carbon"}, {2}, {2}},
    HalfDisc{0.5, 75., 0.2, 4, oriented_material},
    ThinWalled{
      ShapeKind::angle, 0.7, 0.5, {0.1}, {0.1}, 1, 1, oriented_material}};
  for (const SectionShape &shape : shapes)
    for (const std::string theory : {"TE-1", "TE-2", "TE-3"})
      {
        const std::string form = name_of(shape);
        if (theory == "TE-3" && form == "half disc")
          continue;
        BOOST_TEST_CONTEXT(form)
        {
          const auto section = make_section(make_section_mesh(shape, constants),
                                            Theory::parse({"Theory", theory}));
          Beam       beam("beam", section, make_axis(1.3, 2, 1), Placement());
          check_patch(beam, section->law(0, {}).stiffness());
        }
      }
}



BOOST_AUTO_TEST_CASE(assumed_shear)
{
  for (const unsigned int axis_degree : {1, 2, 3})
    for (const char *theory : {"TE-1", "TE-2", "LE-1", "LE-2"})
      {
        const auto section =
          make_section(make_section_mesh(rectangle(0.7, 0.5, {30.}, 2),
                                         {{"material", orthotropic}}),
                       Theory::parse({"Theory", theory}));
        Beam beam("beam",
                  section,
                  make_axis(1.3, 2, axis_degree, true),
                  Placement());
        check_patch(beam, section->law(0, {}).stiffness());
        const double unit = 0.5 * 8. * 0.7 * 0.5 * 1.3;
        for (const Vector &motion : beam.rigid_motions(undisplaced))
          {
            BOOST_TEST(beam.deformation(motion).energy < 1e-12 * unit);
            Vector forces(beam.n_dofs());
            beam.add_internal_forces(motion, forces);
            BOOST_TEST(forces.linfty_norm() < 1e-10);
          }
      }
}



BOOST_AUTO_TEST_CASE(tilted_body)
{
  // The elasticity in scene axes follows from turning the strain into body
  // axes, the other way round than the program does it.
  const Placement placement =
    Placement::from_directions({0.2, -0.1, 0.4},
                               Point<3>(1., 2., 0.5),
                               Point<3>(-0.3, 0.2, 1.));
  const auto section = make_section(distorted_mesh(20.), 2);
  Beam       beam("beam", section, make_axis(1.3, 2, 2), placement);
  check_patch(beam,
              transpose(strain_rotation(placement.axes)) *
                section->law(0, {}).stiffness() *
                strain_rotation(placement.axes));
}



BOOST_AUTO_TEST_CASE(rows_are_the_fields)
{
  // A row applied to u is what sample() gives at the same place, in scene and
  // in ply axes, on a tilted body of two plies, where elements meet and inside.
  const Placement placement =
    Placement::from_directions({0.2, -0.1, 0.4},
                               Point<3>(1., 2., 0.5),
                               Point<3>(-0.3, 0.2, 1.));
  const auto section =
    make_section(rectangle(0.7, 0.5, {20., -50.}, 2), orthotropic, 2);
  const Beam beam("beam", section, make_axis(1.3, 2, 3), placement);
  Vector     u(beam.n_dofs());
  for (unsigned int i = 0; i < u.size(); ++i)
    u[i] = std::sin(1. + 3. * i);

  for (const Point<3> &x :
       {Point<3>(0.1, 0.3, 0.1), Point<3>(0.35, 0.65, 0.25)})
    {
      const auto locations = beam.locate({placement.to_scene(x)})[0];
      BOOST_TEST(locations.size() == (x[2] == 0.25 ? 2 : 1));
      for (const Location &where : locations)
        {
          check_rows_are_fields(beam, where, u);
        }
    }
}



BOOST_AUTO_TEST_CASE(far_from_the_origin)
{
  // Positions carry rounding of the size of the origin; the supports of faces
  // must not: a cantilever 1e5 of its widths away, and turned, bends alike.
  std::vector<double> energies;
  for (const double distance : {0., 1e5})
    {
      const Placement placement =
        Placement::from_directions({distance, -0.3 * distance, distance},
                                   Point<3>(1., 2., 0.5),
                                   Point<3>(-0.3, 0.2, 1.));
      Beam         beam("beam",
                make_section(rectangle(1., 1.), orthotropic, 2),
                make_axis(3., 2),
                placement);
      const Vector u =
        solve_prescribed(beam,
                         prescribe_on_surface(beam, [&](const Point<3> &x) {
                           const Point<3> local = placement.to_body(x);
                           return placement.vector_to_scene(
                             Point<3>(0., 0., local[1] * local[1]));
                         }));
      energies.push_back(beam.deformation(u).energy);
    }
  BOOST_TEST(std::abs(energies[1] / energies[0] - 1.) < 1e-8);
}



BOOST_AUTO_TEST_CASE(rigid_motions_have_no_energy)
{
  const Placement placement =
    Placement::from_directions({5., -3., 0.4},
                               Point<3>(1., 2., 0.5),
                               Point<3>(-0.3, 0.2, 1.));
  for (const unsigned int degree : {1, 2, 3})
    {
      const auto section = make_section(distorted_mesh(20.), degree);
      const Beam beam("beam", section, make_axis(1.3, 3), placement);

      // Energy of a unit strain: E_2 / 2 times the volume, at least.
      const double unit = 0.5 * 8. * 0.7 * 0.5 * 1.3;
      for (const Vector &motion : beam.rigid_motions(undisplaced))
        {
          BOOST_TEST(beam.deformation(motion).energy < 1e-12 * unit);
          Vector forces(beam.n_dofs());
          beam.add_internal_forces(motion, forces);
          BOOST_TEST(forces.linfty_norm() < 1e-10);
        }

      // They are what they are called: at a corner, u = omega x (X - X_c).
      const Point<3> corner = placement.to_scene({0.7, 1.3, 0.});
      const Location there  = beam.locate({corner})[0][0];
      for (unsigned int m = 0; m < 3; ++m)
        {
          Tensor<1, 3> e;
          e[m]               = 1.;
          const auto motions = beam.rigid_motions(undisplaced);
          BOOST_TEST((beam.sample(there, motions[m]).displacement - e).norm() <
                     1e-12);
          BOOST_TEST((beam.sample(there, motions[3 + m]).displacement -
                      cross_product_3d(e, corner - beam.center()))
                       .norm() < 1e-12);
        }
    }
}



BOOST_AUTO_TEST_CASE(strain_first_forces_equal_the_assembled_stiffness)
{
  // On a stubby body both have their digits: int B^T C B u = K u.
  Beam        beam("beam",
            make_section(distorted_mesh(20.), 2),
            make_axis(1.3, 2),
            Placement());
  Constraints none;
  none.close();
  Vector u(beam.n_dofs()), forces(beam.n_dofs()), product(beam.n_dofs());
  for (unsigned int i = 0; i < u.size(); ++i)
    u[i] = std::sin(1. + i);
  beam.add_internal_forces(u, forces);
  assembled_stiffness(beam, none)
    ->for_each_entry(
      [&](const DofIndex row, const DofIndex column, const double value) {
        product[row] += value * u[column];
      });
  product -= forces;
  BOOST_TEST(product.linfty_norm() < 1e-12 * forces.linfty_norm());
}



BOOST_AUTO_TEST_CASE(fewer_fields_at_a_node_are_a_submatrix)
{
  // Node-dependent kinematics: a beam whose second node carries the linear
  // fields only has the stiffness of the full one without the rows and columns
  // of the fields that are left out.
  const auto section = make_section(rectangle(0.7, 0.5), orthotropic, 2);
  const auto axis    = make_axis(1.3, 1, 2);
  std::vector<unsigned int> all(section->n_fields()), linear(9);
  std::iota(all.begin(), all.end(), 0);
  std::iota(linear.begin(), linear.end(), 0);
  Beam full("full", section, axis, Placement());
  Beam mixed("mixed", section, axis, Placement(), {all, linear, all});
  BOOST_TEST(mixed.n_dofs() == 2 * all.size() + 9);

  Constraints none;
  none.close();
  std::map<std::pair<DofIndex, DofIndex>, double> entries;
  assembled_stiffness(full, none)
    ->for_each_entry(
      [&](const DofIndex row, const DofIndex column, const double value) {
        entries[{row, column}] = value;
      });
  const auto to_full = [&](const DofIndex dof) {
    const unsigned int node = dof < all.size()     ? 0 :
                              dof < all.size() + 9 ? 1 :
                                                     2;
    return full.dofs().first(node) + mixed.dofs().field_of(dof);
  };
  double worst = 0.;
  assembled_stiffness(mixed, none)
    ->for_each_entry(
      [&](const DofIndex row, const DofIndex column, const double value) {
        worst = std::max(worst,
                         std::abs(value -
                                  entries.at({to_full(row), to_full(column)})));
      });
  BOOST_TEST(worst < 1e-12);
  for (const Vector &motion : mixed.rigid_motions(undisplaced))
    BOOST_TEST(mixed.deformation(motion).energy < 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()
