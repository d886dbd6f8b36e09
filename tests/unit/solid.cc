// SPDX-License-Identifier: LGPL-2.1-or-later

// Solids: rigid motions, rates, the same space as a beam's, and the
// points of their surfaces.

#include "entries.h"
#include "harmonic.h"
#include "patch_states.h"
#include "solid_fixtures.h"

#include <lamella/base/exceptions.h>
#include <lamella/body/parameters.h>
#include <lamella/body/surface_topology.h>
#include <lamella/shape/shapes.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(solid)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /// A force over the end of a clamped body.
  Solved
  cantilever(std::unique_ptr<Body> body)
  {
    return solve_linear(std::move(body),
                        {clamp("start")},
                        {traction("end", "0.3", "0.2", "1")});
  }
} // namespace

BOOST_AUTO_TEST_CASE(rigid_motions)
{
  for (const unsigned int degree : {1, 2})
    {
      const Solid    solid("solid",
                        distorted(one_material()),
                        axis_mesh(1.3, 3),
                        tilted,
                        degree,
                        around_a_corner);
      const double   unit    = 0.5 * 8. * 0.7 * 0.5 * 1.3;
      const auto     motions = solid.rigid_motions(undisplaced);
      const Point<3> corner  = tilted.to_scene({0.7, 1.3, 0.});
      const Location there   = solid.locate({corner})[0][0];
      for (unsigned int m = 0; m < 6; ++m)
        {
          BOOST_TEST(solid.deformation(motions[m]).energy < 1e-12 * unit);
          Vector forces(solid.n_dofs());
          solid.add_internal_forces(motions[m], forces);
          BOOST_TEST(forces.linfty_norm() < 1e-10);
          Tensor<1, 3> e;
          e[m % 3] = 1.;
          const Tensor<1, 3> due =
            m < 3 ? e : cross_product_3d(e, corner - solid.center());
          BOOST_TEST(
            (solid.sample(there, motions[m]).displacement - due).norm() <
            1e-12);
          BOOST_TEST(std::abs(solid.deformation(motions[m]).max_rotation -
                              (m < 3 ? 0. : 1.)) < 1e-12);
        }
    }
}



BOOST_AUTO_TEST_CASE(geometry)
{
  // On curved and divided hexahedra: the points of integration are what is
  // evaluated one by one, and are found again.
  for (const unsigned int degree : {1, 2})
    {
      const Solid solid(
        "solid",
        make_section_mesh(
          HalfDisc{0.5, 75., 0.2, 4, OrientedMaterial{"material", 20.}},
          {{"material", orthotropic}}),
        axis_mesh(1.3, 2),
        tilted,
        degree,
        {0, {{{0.5, 0., 0.5}, 0.2, 1}}});
      BOOST_TEST(!solid.hexahedra().hanging_nodes().empty());
      const Hexahedron element(degree);
      for (unsigned int cell = 0; cell < solid.hexahedra().cells().size();
           ++cell)
        {
          Hexahedron::Nodes nodes;
          for (const unsigned int node : solid.hexahedra().cells()[cell].nodes)
            nodes.push_back(solid.hexahedra().nodes()[node]);
          for (const HexahedronPoint &point : element.quadrature_points(nodes))
            {
              const HexahedronPoint same = element.evaluate(nodes, point.unit);
              BOOST_TEST(point.position.distance(same.position) < 1e-14);
              BOOST_TEST((point.jacobian - same.jacobian).norm() < 1e-13);
              for (unsigned int i = 0; i < nodes.size(); ++i)
                {
                  BOOST_TEST(std::abs(point.N[i] - same.N[i]) < 1e-14);
                  BOOST_TEST((point.gradients[i] - same.gradients[i]).norm() <
                             1e-12 * point.gradients[i].norm() + 1e-12);
                }
              const Location found =
                solid.locate({tilted.to_scene(point.position)})[0][0];
              BOOST_TEST(found.places[0].cell == cell);
              BOOST_TEST(found.places[0].unit.distance(point.unit) < 1e-12);
            }
        }
    }
}



BOOST_AUTO_TEST_CASE(rates)
{
  // Against a smooth exact solution prescribed on the surface: h^(p+1) in
  // displacements, h^p in strains (h^2 at best for the modes of degree 1).
  const auto errors = [](const unsigned int degree, const unsigned int cells) {
    Solid        solid("solid",
                make_section_mesh(rectangle(1., 1., {0.}, cells, cells),
                                  {{"material",
                                           EngineeringConstants::isotropic(1., 0.3)}}),
                axis_mesh(1., cells),
                Placement(),
                degree);
    const Vector u =
      solve_prescribed(solid, prescribe_on_surface(solid, harmonic::exact), 0);
    return harmonic::errors(solid, u, 3);
  };
  for (const unsigned int degree : {1, 2})
    {
      const auto coarse   = errors(degree, degree == 1 ? 3 : 2),
                 fine     = errors(degree, degree == 1 ? 6 : 4);
      const double u      = std::log2(coarse[0] / fine[0]),
                   strain = std::log2(coarse[1] / fine[1]);
      BOOST_TEST_MESSAGE("Q" << degree << ": rates " << u << " and " << strain);
      BOOST_TEST(u > degree + 0.85);
      BOOST_TEST(u < degree + 1.6);
      BOOST_TEST(strain > degree - 0.15);
    }
}



BOOST_AUTO_TEST_CASE(same_space_as_a_beam)
{
  // A section of Q2 cells times B3 on the same mesh is the space of Q2
  // hexahedra: the same displacements, stresses and energy, from a block to
  // L/h = 100, on plies, on a distorted section and on curved cells.
  const Materials constants{{"material", orthotropic}};
  const auto      plies =
    make_section_mesh(rectangle(0.7, 0.5, {0., 90., 30.}, 2, 1), constants);
  const auto curved = make_section_mesh(
    HalfDisc{0.5, 75., 0.2, 4, OrientedMaterial{"material", 20.}}, constants);
  for (const auto &section : {plies, distorted(plies), curved})
    for (const double slenderness : {1., 10., 100.})
      {
        const AxisMesh axis = axis_mesh(0.5 * slenderness, 6);
        const Solved   beam = cantilever(
                       std::make_unique<Beam>("beam",
                                              make_section(section, 2),
                                              std::make_shared<Axis>(axis),
                                              tilted)),
                     solid = cantilever(std::make_unique<Solid>(
                       "solid", section, axis, tilted, 2));
        BOOST_TEST(solid.structure->n_dofs() == beam.structure->n_dofs());
        BOOST_TEST(std::abs(solid.strain_energy() / beam.strain_energy() - 1.) <
                   1e-8);
        const double L = axis.length;
        for (const Point<3> &x : {Point<3>(0.3, L, 0.2),
                                  Point<3>(0.35, 0.4 * L, 0.1),
                                  Point<3>(0.3, 0.5 * L, 0.15)})
          {
            const FieldSample a = beam.at(tilted.to_scene(x)),
                              b = solid.at(tilted.to_scene(x));
            const double scale =
              beam.at(tilted.to_scene({0.35, 0.4 * L, 0.1})).stress.norm();
            BOOST_TEST((a.displacement - b.displacement).norm() <
                       1e-8 * a.displacement.norm());
            BOOST_TEST((a.stress - b.stress).norm() < 1e-8 * scale);
            BOOST_TEST((a.ply_stress - b.ply_stress).norm() < 1e-8 * scale);
          }
      }
}



BOOST_AUTO_TEST_CASE(incompatible_modes_do_not_lock)
{
  // One element over the height, twenty times as long as high: with the modes
  // bending comes out, without them (Q1 by itself is what LE-1 with B2 and full
  // shear strains is) it is a hundred times too stiff.
  const auto section =
    make_section_mesh(rectangle(1., 1.),
                      {{"material",
                        EngineeringConstants::isotropic(1000., 0.)}});
  const AxisMesh axis       = axis_mesh(100., 5, 1);
  const double   due        = 100. * 100. * 100. / (3. * 1000. / 12.);
  const auto     deflection = [](const Solved &solved) {
    return solved.at({0.5, 100., 0.5}).displacement[2];
  };
  const double with_modes = deflection(cantilever(std::make_unique<Solid>(
                 "solid", section, axis, Placement(), 1))),
               without    = deflection(
                 cantilever(std::make_unique<Beam>("beam",
                                                   make_section(section, 1),
                                                   std::make_shared<Axis>(axis),
                                                   Placement())));
  BOOST_TEST_MESSAGE("deflection over beam theory's: "
                     << with_modes / due << " with modes, " << without / due
                     << " without");
  BOOST_TEST(std::abs(with_modes / due - 1.) < 0.02);
  BOOST_TEST(without / due < 0.02);
}



BOOST_AUTO_TEST_CASE(surfaces)
{
  for (const unsigned int degree : {1, 2})
    {
      const Solid                               solid("solid",
                        one_material(),
                        axis_mesh(1.3, 3),
                        tilted,
                        degree,
                        around_a_corner);
      const std::map<std::string, double>       areas{{"bottom", 0.7 * 1.3},
                                                {"top", 0.7 * 1.3},
                                                {"left", 0.5 * 1.3},
                                                {"right", 0.5 * 1.3},
                                                {"start", 0.35},
                                                {"end", 0.35},
                                                {"ends", 0.7},
                                                {"all", 0.7 + 2.4 * 1.3}};
      const std::map<std::string, Tensor<1, 3>> normals{
        {"bottom", Point<3>(0., 0., -1.)},
        {"top", Point<3>(0., 0., 1.)},
        {"left", Point<3>(-1., 0., 0.)},
        {"right", Point<3>(1., 0., 0.)},
        {"start", Point<3>(0., -1., 0.)},
        {"end", Point<3>(0., 1., 0.)}};
      for (const auto &[surface, area] : areas)
        {
          double       of_points = 0., of_quadrature = 0., of_facets = 0.;
          Tensor<1, 3> moment, of_moment;
          const dealii::QGauss<2> gauss(2);
          for (const SurfacePoint &p : solid.surface_points(surface))
            {
              BOOST_TEST(p.area > 0.);
              of_points += p.area;
              moment += p.area * p.position;
              BOOST_TEST(p.location.position.distance(
                           solid.position(p.location.places[0])) < 1e-12);
            }
          for (const SurfaceFacet &facet : surface_facets(solid, surface))
            {
              for (unsigned int q = 0; q < gauss.size(); ++q)
                {
                  const SurfacePoint p =
                    solid.surface_point(facet, gauss.point(q));
                  of_quadrature += gauss.weight(q) * p.area;
                  of_moment += gauss.weight(q) * p.area * p.position;
                  if (normals.count(surface) > 0)
                    BOOST_TEST(
                      (p.normal - tilted.vector_to_scene(normals.at(surface)))
                        .norm() < 1e-12);
                }
              const SurfacePoint middle =
                solid.surface_point(facet, {0.5, 0.5});
              of_facets += middle.area;
              BOOST_TEST(
                (middle.position - 0.25 * (facet.corners[0] + facet.corners[1] +
                                           facet.corners[2] + facet.corners[3]))
                  .norm() < 1e-12);
            }
          BOOST_TEST(std::abs(of_points - area) < 1e-12);
          BOOST_TEST(std::abs(of_quadrature - area) < 1e-12);
          BOOST_TEST(std::abs(of_facets - area) < 1e-12);
          // Tributary areas integrate what is linear, hanging nodes or not.
          BOOST_TEST((moment - of_moment).norm() < 1e-12);
        }
      BOOST_TEST(solid.constraint_points("top").size() ==
                 solid.surface_points("top").size());
    }
}



BOOST_AUTO_TEST_CASE(points)
{
  // Rows are the fields, places are where they say, on both sides of a ply
  // interface and across hanging faces.
  const auto section = make_section_mesh(rectangle(0.7, 0.5, {20., -50.}, 2),
                                         {{"material", orthotropic}});
  for (const unsigned int degree : {1, 2})
    {
      const Solid solid(
        "solid", section, axis_mesh(1.3, 2), tilted, degree, around_a_corner);
      Vector u(solid.n_dofs());
      for (unsigned int i = 0; i < u.size(); ++i)
        u[i] = std::sin(1. + 3. * i);
      solid.kinematic_constraints().distribute(u);
      for (const Point<3> &x : {Point<3>(0.1, 0.3, 0.1),
                                Point<3>(0.35, 0.65, 0.25),
                                Point<3>(0.5, 0.325, 0.3)})
        {
          const auto locations = solid.locate({tilted.to_scene(x)})[0];
          BOOST_TEST(locations.size() == (x[2] == 0.25 ? 2 : 1));
          for (const Location &where : locations)
            {
              for (const Location::Place &place : where.places)
                BOOST_TEST(solid.position(place).distance(tilted.to_scene(x)) <
                           1e-12);
              check_rows_are_fields(solid, where, u);
            }
        }
      BOOST_TEST(solid.locate({tilted.to_scene({0.8, 0.3, 0.1})})[0].empty());
    }
}



BOOST_AUTO_TEST_CASE(lines_and_cuts)
{
  const Solid solid("solid",
                    one_material(2),
                    axis_mesh(1., 2),
                    Placement(),
                    2,
                    {0, {{{0.7, 0., 0.5}, 0.05, 1}}});
  // Along the axis through the divided cells and below them.
  BOOST_TEST(solid.line_breaks({0.6, 0., 0.4}, {0.6, 1., 0.4}) ==
               (std::vector<double>{0., 0.25, 0.5, 1.}),
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(solid.line_breaks({0.1, 0., 0.1}, {0.1, 1., 0.1}) ==
               (std::vector<double>{0., 0.5, 1.}),
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(solid.line_breaks({0.6, 0.1, 0.}, {0.6, 0.1, 0.5}) ==
               (std::vector<double>{0., 0.5, 0.75, 1.}),
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(solid.line_degree({0., 0., 0.}, {0., 1., 0.}) == 2);
  BOOST_TEST(solid.line_degree({0., 0., 0.}, {0.1, 1., 0.}) == 4);

  // A cut is a section's area; its fields are those of probes.
  Vector u(solid.n_dofs());
  for (unsigned int i = 0; i < u.size(); ++i)
    u[i] = std::sin(1. + 3. * i);
  solid.kinematic_constraints().distribute(u);
  for (const double at : {0., 0.1, 0.25, 0.5, 1.})
    {
      const auto cells = solid.cut(at, 2, u);
      BOOST_TEST(cells.size() == (at < 0.5 ? 7 : 4));
      // The middles of cells lie on no other cell of the section.
      for (const OutputCell &cell : cells)
        {
          const FieldSample &s = cell.samples[4];
          const FieldSample  probe =
            solid.sample(solid.locate({cell.positions[4]})[0][0], u);
          BOOST_TEST((s.displacement - probe.displacement).norm() < 1e-10);
          if (at != 0.5)
            BOOST_TEST((s.stress - probe.stress).norm() <
                       1e-10 * probe.stress.norm());
        }
    }
}



BOOST_AUTO_TEST_CASE(a_section_with_hanging_nodes_does_not_extrude)
{
  const auto regular = one_material(2);
  auto       mesh    = std::make_shared<SectionMesh>();
  mesh->mesh.copy_triangulation(regular->mesh);
  mesh->plies      = regular->plies;
  mesh->boundaries = regular->boundaries;
  mesh->mesh.begin_active()->set_refine_flag();
  mesh->mesh.execute_coarsening_and_refinement();
  const auto says_why = [](const InputError &error) {
    return std::string(error.what()).find("[body.hanging-nodes]") !=
           std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(Solid("solid", mesh, axis_mesh(1.3, 2), Placement(), 2),
                        InputError,
                        says_why);
}



BOOST_AUTO_TEST_CASE(entries_of_a_refinement)
{
  const auto read = [](const Settings &settings) {
    return parsed<SolidParameters>("Body b/Kinematics", settings, tilted);
  };
  BOOST_TEST(read({}).everywhere == 0);
  BOOST_TEST(read({}).balls.empty());
  const SolidRefinement given =
    read({{"Refinements", "2"}, {"Refine near", "1, 2, 3: 0.1: 1|0,0,0:2:0"}});
  BOOST_TEST(given.everywhere == 2);
  BOOST_TEST_REQUIRE(given.balls.size() == 2);
  // The center comes in the scene's axes.
  BOOST_TEST(
    tilted.to_scene(given.balls[0].center).distance(Point<3>(1., 2., 3.)) <
    1e-14);
  BOOST_TEST(given.balls[0].radius == 0.1);
  BOOST_TEST(given.balls[0].times == 1);
  BOOST_TEST(given.balls[1].times == 0);

  for (const auto &[name, value] : Settings{{"Refinements", "9"},
                                            {"Refinements", "1.5"},
                                            {"Refinements", ""},
                                            {"Refine near", "0, 0, 0: 0.1"},
                                            {"Refine near", "0, 0: 0.1: 1"},
                                            {"Refine near", "0, 0, 0: -1: 1"},
                                            {"Refine near", "0, 0, 0: 1: 9"}})
    BOOST_CHECK_EXCEPTION(read({{name, value}}),
                          InputError,
                          [path = "Body b/Kinematics/" +
                                  name](const InputError &error) {
                            return error.path() == path;
                          });
}

BOOST_AUTO_TEST_SUITE_END()
