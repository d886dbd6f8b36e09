// SPDX-License-Identifier: LGPL-2.1-or-later

// The hierarchical basis of LE: its leading parts span LE of lower degrees
// exactly, its functions are continuous whatever the directions of edges are,
// and beams whose nodes mix degrees are what a subspace says: as stiff as the
// plain LE where all nodes are alike, in between where they are not.

#include "patch_states.h"

#include <lamella/adapt/node_fields.h>
#include <lamella/body/body_solver.h>
#include <lamella/shape/shapes.h>

#include <deal.II/grid/grid_tools.h>

#include <boost/test/unit_test.hpp>

#include <random>

BOOST_AUTO_TEST_SUITE(hierarchical)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const EngineeringConstants
    orthotropic{165., 9., 8., 5.6, 5.2, 2.8, 0.34, 0.3, 0.45};

  using Mesh  = std::shared_ptr<const SectionMesh>;
  using Lists = std::vector<std::vector<unsigned int>>;



  Mesh
  regular_mesh()
  {
    return make_section_mesh(rectangle(0.7, 0.5, {30., -45.}, 2),
                             {{"material", orthotropic}});
  }



  /// 3 x 3 cells with the inner vertices moved: no parallelograms.
  Mesh
  distorted_mesh()
  {
    const auto regular =
      make_section_mesh(rectangle(0.7, 0.5, {20., 20., 20.}, 3),
                        {{"material", orthotropic}});
    auto mesh = std::make_shared<SectionMesh>();
    mesh->mesh.copy_triangulation(regular->mesh);
    mesh->plies      = regular->plies;
    mesh->boundaries = regular->boundaries;
    dealii::GridTools::distort_random(0.25, mesh->mesh, true, 7);
    return mesh;
  }



  Mesh
  mesh_of(const SectionShape &shape)
  {
    return make_section_mesh(shape, {{"carbon", orthotropic}});
  }

  const OrientedMaterial carbon{"carbon", 20.};



  /// Unstructured quadrilaterals by Gmsh.
  Mesh
  gmsh_mesh()
  {
    return mesh_of(
      SectionFile{std::string(LAMELLA_SOURCE_DIR) + "/prm/sections/hexagon.msh",
                  0.05,
                  {{"carbon", carbon}},
                  "Section s"});
  }



  Mesh
  curved_mesh()
  {
    return mesh_of(HalfDisc{0.5, 75., 0.2, 4, carbon});
  }



  LagrangeElement
  hierarchical_element(const Mesh &mesh, const unsigned int degree)
  {
    return LagrangeElement(mesh,
                           degree,
                           LagrangeElement::default_column_aspect,
                           LagrangeElement::Basis::hierarchical);
  }



  std::shared_ptr<const Section>
  hierarchical_section(const Mesh &mesh, const unsigned int degree)
  {
    Theory theory       = layer_wise(degree);
    theory.hierarchical = true;
    return make_section(mesh, theory);
  }



  /// LE-q with the integration points of a higher degree: on cells that are no
  /// parallelograms integrals are exact for none.
  class FinelyIntegrated : public LagrangeElement
  {
  public:
    FinelyIntegrated(const Mesh        &mesh,
                     const unsigned int degree,
                     const unsigned int points)
      : LagrangeElement(mesh, degree)
      , points(points)
    {}

    unsigned int
    n_gauss_points() const override
    {
      return points;
    }

  private:
    unsigned int points;
  };



  /// The fields of LE-q in @p section.
  std::vector<unsigned int>
  leading_fields(const Section &section, const unsigned int q)
  {
    std::vector<unsigned int> list;
    for (unsigned int alpha = 0; alpha < section.n_fields(); ++alpha)
      if (section.field_degree(alpha) <= q)
        list.push_back(alpha);
    return list;
  }



  /// @p degrees for the nodes of an axis.
  std::unique_ptr<Beam>
  beam_of_degrees(const std::shared_ptr<const Section> &section,
                  const std::shared_ptr<const Axis>    &axis,
                  const std::vector<unsigned int>      &degrees)
  {
    Lists lists;
    for (const unsigned int q : degrees)
      lists.push_back(leading_fields(*section, q));
    return std::make_unique<Beam>("beam", section, axis, Placement(), lists);
  }



  std::unique_ptr<Beam>
  beam_of_degree(const std::shared_ptr<const Section> &section,
                 const std::shared_ptr<const Axis>    &axis,
                 const unsigned int                    q)
  {
    return beam_of_degrees(section,
                           axis,
                           std::vector<unsigned int>(axis->n_nodes(), q));
  }



  /// The numbers of a cantilever under a traction that bends and twists it:
  /// strain energy and the tip's displacement.
  std::array<double, 2>
  cantilever(std::unique_ptr<Body> body, const Point<3> &tip)
  {
    const Solved solved = solve_linear(std::move(body),
                                       {clamp("start")},
                                       {traction("end", "1", "0.1", "x")});
    return {{solved.strain_energy(),
             solved.at(tip).displacement * Point<3>(1, 1, 1)}};
  }



  /// All functions at a place, by their numbers.
  std::vector<double>
  all_values(const LagrangeElement &element,
             const unsigned int     cell,
             const Point<2>        &unit)
  {
    std::vector<double>  values(element.n_functions(), 0.);
    const FunctionValues at      = element.evaluate(cell, unit);
    const auto          &numbers = element.cell_functions(cell);
    for (unsigned int k = 0; k < numbers.size(); ++k)
      values[numbers[k]] = at.values[k];
    return values;
  }
} // namespace

BOOST_AUTO_TEST_CASE(leading_functions_span_lower_degrees)
{
  // The nodal functions of LE-q are combinations of the leading functions,
  // found in the nodes of LE-q and true at all other places, and there are as
  // many of the one as of the other.
  const std::vector<Point<2>> places{
    {0.1, 0.2}, {0.9, 0.35}, {0.5, 0.77}, {0., 0.6}, {0.3, 1.}};
  for (const Mesh &mesh : {regular_mesh(), distorted_mesh(), gmsh_mesh()})
    for (const unsigned int q : {1, 2, 3})
      {
        const LagrangeElement fine   = hierarchical_element(mesh, 4 - (q == 1)),
                              coarse = LagrangeElement(mesh, q);
        unsigned int n               = 0;
        while (n < fine.n_functions() && fine.function_degree(n) <= q)
          ++n;
        BOOST_TEST_REQUIRE(n == coarse.n_functions());
        const auto nodes = fine.coarse_section_grid(q);
        BOOST_TEST_REQUIRE(nodes.size() == n);
        dealii::FullMatrix<double> F(n), G(n), to_fine(n);
        for (unsigned int i = 0; i < n; ++i)
          {
            const auto f = all_values(fine, nodes[i].cell, nodes[i].unit),
                       g = all_values(coarse, nodes[i].cell, nodes[i].unit);
            for (unsigned int k = 0; k < n; ++k)
              {
                F(i, k) = f[k];
                G(i, k) = g[k];
              }
          }
        F.gauss_jordan();
        F.mmult(to_fine, G);
        double worst = 0.;
        for (unsigned int cell = 0; cell < mesh->mesh.n_active_cells(); ++cell)
          for (const Point<2> &unit : places)
            {
              const auto f = all_values(fine, cell, unit),
                         g = all_values(coarse, cell, unit);
              for (unsigned int k = 0; k < n; ++k)
                {
                  double sum = 0.;
                  for (unsigned int i = 0; i < n; ++i)
                    sum += f[i] * to_fine(i, k);
                  worst = std::max(worst, std::abs(sum - g[k]));
                }
            }
        BOOST_TEST(worst < 1e-10);
      }
}



BOOST_AUTO_TEST_CASE(gradients_are_derivatives)
{
  // On a distorted and on a curved cell, against central differences.
  for (const Mesh &mesh : {distorted_mesh(), curved_mesh()})
    {
      const LagrangeElement element = hierarchical_element(mesh, 4);
      const Point<2>        unit(0.3, 0.6);
      constexpr double      step = 1e-5;
      for (unsigned int cell = 0; cell < mesh->mesh.n_active_cells(); ++cell)
        {
          const FunctionValues at = element.evaluate(cell, unit);
          for (unsigned int d = 0; d < 2; ++d)
            {
              Point<2> ahead = unit, behind = unit;
              ahead[d] += step;
              behind[d] -= step;
              const FunctionValues a = element.evaluate(cell, ahead),
                                   b = element.evaluate(cell, behind);
              for (unsigned int k = 0; k < at.values.size(); ++k)
                {
                  const double difference =
                                 (a.values[k] - b.values[k]) / (2. * step),
                               derivative =
                                 (transpose(at.jacobian) * at.gradients[k])[d];
                  BOOST_TEST(std::abs(difference - derivative) < 1e-8);
                }
            }
        }
    }
}



BOOST_AUTO_TEST_CASE(functions_are_continuous_across_edges)
{
  // Odd functions change sign with the direction of their edge. The last mesh
  // is two cells turned against each other by hand: their common side runs up
  // in the one and down in the other. (deal.II's FE_Q, of which the map and so
  // x and z are made, wants sides that agree, and readers of meshes see to it.)
  auto turned = std::make_shared<SectionMesh>();
  {
    const std::vector<Point<2>> vertices{
      {0., 0.}, {1., 0.}, {2.2, 0.1}, {0.1, 1.}, {1.1, 0.9}, {2., 1.}};
    std::vector<dealii::CellData<2>> cells(2);
    cells[0].vertices = {0, 1, 3, 4};
    cells[1].vertices = {5, 4, 2, 1};
    turned->mesh.create_triangulation(vertices, cells, {});
  }
  unsigned int reversed = 0;
  for (const Mesh &mesh :
       {gmsh_mesh(), distorted_mesh(), curved_mesh(), Mesh(turned)})
    {
      const LagrangeElement element = hierarchical_element(mesh, 5);
      for (const auto &cell : mesh->mesh.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          {
            if (cell->at_boundary(f))
              continue;
            const auto         other = cell->neighbor(f);
            const unsigned int g     = cell->neighbor_of_neighbor(f);
            const bool         same =
              cell->vertex_index(
                dealii::GeometryInfo<2>::face_to_cell_vertices(f, 0)) ==
              other->vertex_index(
                dealii::GeometryInfo<2>::face_to_cell_vertices(g, 0));
            reversed += !same;
            double worst = 0.;
            for (const double t : {0., 0.1, 0.37, 0.5, 0.8, 1.})
              {
                const auto a = all_values(element,
                                          cell->active_cell_index(),
                                          face_point(f, t)),
                           b = all_values(element,
                                          other->active_cell_index(),
                                          face_point(g, same ? t : 1. - t));
                for (unsigned int k = 3; k < a.size(); ++k)
                  worst = std::max(worst, std::abs(a[k] - b[k]));
              }
            BOOST_TEST(worst < 1e-12);
          }
    }
  BOOST_TEST(reversed > 0);
}



BOOST_AUTO_TEST_CASE(a_body_of_a_lower_degree_is_that_of_the_lower_degree)
{
  // LE-q in the space of LE-p and LE-q by itself: the same clamped cantilever
  // to rounding, if integrated alike (on parallelograms each exactly).
  const auto axis = make_axis(1.7, 2);
  for (const Mesh &mesh : {regular_mesh(), distorted_mesh(), gmsh_mesh()})
    {
      const auto         corner = mesh->mesh.begin_active()->vertex(0);
      const Point<3>     tip(corner[0], 1.7, corner[1]);
      const unsigned int p       = mesh->mesh.n_active_cells() > 9 ? 2 : 3;
      const auto         section = hierarchical_section(mesh, p);
      for (unsigned int q = 1; q <= p; ++q)
        {
          const auto plain = std::make_shared<const Section>(
            std::make_unique<FinelyIntegrated>(mesh, q, p + 1), layer_wise(q));
          const auto wanted =
            cantilever(std::make_unique<Beam>("beam", plain, axis, Placement()),
                       tip);
          const auto found = cantilever(beam_of_degree(section, axis, q), tip);
          for (unsigned int k = 0; k < 2; ++k)
            BOOST_TEST(std::abs(found[k] / wanted[k] - 1.) < 1e-10);
        }
    }
}



BOOST_AUTO_TEST_CASE(energies_are_nested)
{
  // Under given loads the energy grows with the space.
  const Point<3>        tip(0.7, 1.7, 0.5);
  const auto            axis    = make_axis(1.7, 4);
  const auto            section = hierarchical_section(regular_mesh(), 3);
  std::vector<unsigned> near_2(13, 1), near_3(13, 1), two_three(13, 2);
  for (unsigned int node = 5; node < 9; ++node)
    {
      near_2[node]    = 2;
      near_3[node]    = 3;
      two_three[node] = 3;
    }
  double before = 0.;
  for (const auto &degrees : {std::vector<unsigned>(13, 1),
                              near_2,
                              near_3,
                              std::vector<unsigned>(13, 3)})
    {
      const double energy =
        cantilever(beam_of_degrees(section, axis, degrees), tip)[0];
      BOOST_TEST(energy > before * (1. + 1e-6));
      before = energy;
    }
  const double two = cantilever(beam_of_degree(section, axis, 2), tip)[0],
               mixed =
                 cantilever(beam_of_degrees(section, axis, two_three), tip)[0];
  BOOST_TEST(two < mixed);
  BOOST_TEST(mixed < before);
}



BOOST_AUTO_TEST_CASE(patches_of_mixed_degrees)
{
  // Uniform states of strain, over nodes of all degrees, also in curved cells,
  // where x and z are in no part by themselves but the whole.
  for (const Mesh &mesh : {distorted_mesh(), curved_mesh()})
    {
      const auto section = hierarchical_section(mesh, 3);
      for (const std::vector<unsigned int> &degrees :
           {std::vector<unsigned int>{1, 1, 2, 3, 3},
            std::vector<unsigned int>{1, 3, 1, 2, 1}})
        {
          const auto beam =
            beam_of_degrees(section, make_axis(1.3, 2, 2), degrees);
          check_patch(*beam, section->law(0, {}).stiffness());
        }
    }
}



BOOST_AUTO_TEST_CASE(rigid_motions_have_no_strain)
{
  for (const Mesh &mesh : {distorted_mesh(), curved_mesh()})
    {
      const auto section = hierarchical_section(mesh, 3);
      const auto beam =
        beam_of_degrees(section, make_axis(1.3, 2, 2), {1, 1, 2, 3, 1});
      for (const Vector &motion : beam->rigid_motions(undisplaced))
        {
          Vector force(beam->n_dofs());
          beam->add_internal_forces(motion, force);
          BOOST_TEST(force.linfty_norm() < 1e-10);
        }
    }
}



BOOST_AUTO_TEST_CASE(points_follow_the_degree)
{
  // 2 x 2 cells: 9 nodes of LE-1, 25 of LE-2; 3 and 5 on a side. Weights sum to
  // the area of a side, as those of one degree do.
  const auto section = hierarchical_section(regular_mesh(), 2);
  const auto beam =
    beam_of_degrees(section, make_axis(1.3, 2, 2), {1, 1, 2, 2, 2});
  BOOST_TEST(beam->constraint_points("start").size() == 9);
  BOOST_TEST(beam->constraint_points("end").size() == 25);
  BOOST_TEST(beam->surface_points("top").size() == 2 * 3 + 3 * 5);
  BOOST_TEST(beam->body_points().size() == 2 * 9 + 3 * 25);
  for (const auto &[surface, area] :
       {std::make_pair("top", 0.7 * 1.3), std::make_pair("ends", 2 * 0.35)})
    {
      double sum = 0.;
      for (const SurfacePoint &point : beam->surface_points(surface))
        sum += point.area;
      BOOST_TEST(std::abs(sum / area - 1.) < 1e-12);
    }
  // Rows there are independent: a load or a support at each of them.
  const auto rows = beam->rows({beam->constraint_points("start")}, undisplaced);
  for (const auto &row : rows)
    for (unsigned int c = 0; c < 3; ++c)
      for (const auto &[dof, weight] : row[c].entries())
        BOOST_TEST(beam->dofs().node_of(dof) == 0);
}



BOOST_AUTO_TEST_CASE(pieces_by_hand)
{
  // LE-1, LE-3, SV beside each other: each node has the leading fields of its
  // degree, between two pieces those of the higher one, and where LE-q meets SV
  // all fields, which hold both.
  BodyDescription body;
  body.name          = "beam";
  body.section       = "section";
  body.axis.length   = 9.;
  body.axis.elements = {9};
  const auto piece   = [](const char *name) {
    Theory theory        = Theory::parse({"Theories", name});
    theory.section_order = 3;
    theory.hierarchical  = true;
    return theory;
  };
  body.pieces.theories = {piece("LE-1"),
                          piece("LE-2"),
                          piece("LE-1"),
                          piece("SV")};
  body.pieces.breaks   = {3., 5., 7.};
  body.theory          = body.pieces.leading();
  const SectionMeshes meshes{{"section", regular_mesh()}};
  Bodies              bodies = make_bodies({body}, meshes);
  choose_fields(bodies, {body}, {clamp("start")}, {}, {});
  const auto    &beam    = dynamic_cast<const Beam &>(*bodies[0]);
  const Section &section = beam.section();
  BOOST_TEST(section.element().degree() == 3);
  for (unsigned int node = 0; node < beam.axis().n_nodes(); ++node)
    {
      const double y         = beam.axis().nodes()[node];
      const bool   in_two    = y > 3. - 1e-9 && y < 5. + 1e-9,
                 at_SV       = std::abs(y - 7.) < 1e-9;
      const std::size_t size = at_SV ? 147 : y > 7. ? 12 : in_two ? 75 : 27;
      BOOST_TEST(beam.dofs().fields(node).size() == size);
    }
  const Solved solved = solve_linear(std::move(bodies[0]),
                                     {clamp("start")},
                                     {traction("end", "1", "0.1", "x")});
  BOOST_TEST(solved.state.free_corrections.front() < 1e-9);
}



BOOST_AUTO_TEST_CASE(condition_numbers)
{
  // Of a cantilever's stiffness scaled to a unit diagonal, largest over
  // smallest eigenvalue. Printed for doc/theory/stable-basis.md. That of nodes
  // of lower degree is part of it, with eigenvalues in between.
  const auto axis    = make_axis(2., 2);
  const auto measure = [&](std::unique_ptr<Beam> beam) {
    const unsigned int first = beam->dofs().first(1),
                       n     = beam->n_dofs() - first;
    dealii::LAPACKFullMatrix<double> K(n);
    Constraints                      none;
    none.close();
    assembled_stiffness(*beam, none)
      ->for_each_entry(
        [&](const DofIndex i, const DofIndex j, const double value) {
          if (i >= first && j >= first)
            K(i - first, j - first) = K(j - first, i - first) = value;
        });
    std::vector<double> scale;
    for (unsigned int i = 0; i < n; ++i)
      scale.push_back(1. / std::sqrt(K(i, i)));
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        K(i, j) *= scale[i] * scale[j];
    dealii::Vector<double>     values(n);
    dealii::FullMatrix<double> vectors;
    K.compute_eigenvalues_symmetric(0., 1e6, 0., values, vectors);
    return std::make_pair(n, values[values.size() - 1] / values[0]);
  };
  std::map<std::string, double> found;
  const auto report = [&](const std::string &name, std::unique_ptr<Beam> beam) {
    const auto [n, condition] = measure(std::move(beam));
    found[name]               = condition;
    BOOST_TEST_MESSAGE("| " << name << " | " << n << " | "
                            << std::setprecision(2) << condition << " |");
  };
  const Mesh mesh = regular_mesh();
  for (const unsigned int p : {2, 3})
    {
      const std::string name = "LE-" + std::to_string(p);
      report(name + ", nodal",
             std::make_unique<Beam>(
               "beam", make_section(mesh, p), axis, Placement()));
      report(name + ", hierarchical",
             beam_of_degree(hierarchical_section(mesh, p), axis, p));
      // As large as nodal functions make it.
      const double ratio =
        found[name + ", hierarchical"] / found[name + ", nodal"];
      BOOST_TEST(ratio < 10.);
      BOOST_TEST(ratio > 0.1);
    }
  report("LE-1, LE-2, LE-1",
         beam_of_degrees(hierarchical_section(mesh, 2),
                         axis,
                         {1, 1, 2, 2, 2, 1, 1}));
  BOOST_TEST(found["LE-1, LE-2, LE-1"] < found["LE-2, hierarchical"]);
  report("LE-1, LE-3, LE-1",
         beam_of_degrees(hierarchical_section(mesh, 3),
                         axis,
                         {1, 1, 3, 3, 3, 1, 1}));
  BOOST_TEST(found["LE-1, LE-3, LE-1"] < found["LE-3, hierarchical"]);
}

BOOST_AUTO_TEST_SUITE_END()
