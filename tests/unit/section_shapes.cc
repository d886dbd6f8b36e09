// SPDX-License-Identifier: LGPL-2.1-or-later

// Shapes of sections beside the laminate: areas, second moments and lengths of
// boundaries against closed forms, cells that are neither folded nor apart,
// meshes by Gmsh.

#include "entries.h"
#include "fixtures.h"

#include <lamella/base/exceptions.h>
#include <lamella/report/tables.h>
#include <lamella/section/theory_limits.h>
#include <lamella/shape/parameters.h>
#include <lamella/shape/properties.h>
#include <lamella/shape/section_mesh.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

BOOST_AUTO_TEST_SUITE(section_shapes)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;
using dealii::numbers::PI;

namespace
{
  const Materials constants{
    {"carbon", EngineeringConstants::isotropic(10., 0.25)},
    {"foam", EngineeringConstants::isotropic(1., 0.25)}};

  const OrientedMaterial carbon{"carbon", 30.};

  constexpr double R = 0.7;

  const std::string folder = LAMELLA_SOURCE_DIR;



  double
  off(const double value, const double expected)
  {
    return std::abs(value / expected - 1.);
  }



  HalfDisc
  half_disc(const double       graded_towards = 90.,
            const double       radii          = 8.,
            const unsigned int sectors        = 8)
  {
    return {R, graded_towards, R / radii, sectors, carbon};
  }



  ThinWalled
  walls(const ShapeKind            form,
        const std::vector<double> &webs,
        const std::vector<double> &flanges)
  {
    return {form, 3., 4., webs, flanges, 2, 3, carbon};
  }



  /// b h^3 / 12 of a rectangle, its area times its distance squared added, and
  /// the like of x: by hand, from rectangles x0, x1, z0, z1 with a sign.
  struct Rectangle
  {
    double x0, x1, z0, z1, sign;
  };

  struct Rectangles
  {
    double       area = 0.;
    Point<2>     centroid;
    Tensor<2, 2> moments;
  };

  Rectangles
  sum_of(const std::vector<Rectangle> &rectangles)
  {
    Rectangles   sum;
    Tensor<1, 2> first;
    for (const auto &[x0, x1, z0, z1, sign] : rectangles)
      {
        sum.area += sign * (x1 - x0) * (z1 - z0);
        first[0] += sign * (x1 * x1 - x0 * x0) / 2. * (z1 - z0);
        first[1] += sign * (z1 * z1 - z0 * z0) / 2. * (x1 - x0);
      }
    sum.centroid = Point<2>(first / sum.area);
    for (const auto &[x0, x1, z0, z1, sign] : rectangles)
      {
        const double b = x1 - x0, h = z1 - z0, A = sign * b * h,
                     x = (x0 + x1) / 2. - sum.centroid[0],
                     z = (z0 + z1) / 2. - sum.centroid[1];
        sum.moments[0][0] += A * (b * b / 12. + x * x);
        sum.moments[1][1] += A * (h * h / 12. + z * z);
        sum.moments[0][1] += A * x * z;
      }
    return sum;
  }



  /// The smallest Jacobian, over the area of the cell, of the geometry of
  /// LE-@p degree on a grid of points of each cell, corners among them.
  double
  smallest_jacobian(std::shared_ptr<const SectionMesh> mesh,
                    const unsigned int                 degree)
  {
    const LagrangeElement element(mesh, degree);
    double                smallest = 1.;
    for (const auto &cell : mesh->mesh.active_cell_iterators())
      for (unsigned int i = 0; i <= 4; ++i)
        for (unsigned int j = 0; j <= 4; ++j)
          smallest = std::min(smallest,
                              determinant(element
                                            .evaluate(cell->active_cell_index(),
                                                      {i / 4., j / 4.})
                                            .jacobian) /
                                cell->measure());
    return smallest;
  }



  /// The sum of weights on @p boundary, and the integrals of n and x . n.
  struct Edge
  {
    double       length = 0.;
    Tensor<1, 2> normal;
    double       flux = 0.;
  };

  Edge
  edge(const CrossSectionElement &element, const std::string &boundary)
  {
    Edge result;
    for (const EdgePoint &p : edge_quadrature(element, boundary, 5))
      {
        result.length += p.weight;
        result.normal += p.weight * p.normal;
        result.flux += p.weight * (p.position * p.normal);
      }
    return result;
  }
} // namespace

BOOST_AUTO_TEST_CASE(half_disc_against_closed_forms)
{
  for (const double angle : {30., 90., 117., 150.})
    for (const double radii : {2., 8., 1000.})
      for (const unsigned int sectors : {4, 8, 12})
        {
          const auto mesh =
            make_section_mesh(half_disc(angle, radii, sectors), constants);
          check_section_mesh(*mesh, {"Section s", ""});
          const SectionProperties p = section_properties(*mesh);
          BOOST_TEST_INFO("angle " << angle << ", R / finest " << radii << ", "
                                   << sectors << " sectors, "
                                   << mesh->mesh.n_active_cells() << " cells");
          // With four sectors and P far from the top an edge spans half the
          // arc, which the geometry of degree 6 follows to 1e-4.
          const double tolerance =
            sectors == 4 ? 1e-3 : (angle == 90. ? 1e-9 : 1e-5);
          BOOST_TEST(off(p.area, PI * R * R / 2.) < tolerance);
          BOOST_TEST(p.centroid.distance({R, 4. * R / (3. * PI)}) <
                     tolerance * R);
          BOOST_TEST(off(p.second_moments[0][0], PI / 8. * std::pow(R, 4)) <
                     tolerance * 5.);
          BOOST_TEST(off(p.second_moments[1][1],
                         (PI / 8. - 8. / (9. * PI)) * std::pow(R, 4)) <
                     tolerance * 10.);
          // Also that no side of a cell inside is left open.
          BOOST_TEST(p.boundary_lengths.size() == 2);
          BOOST_TEST(off(p.boundary_lengths.at("arc"), PI * R) < tolerance);
          BOOST_TEST(off(p.boundary_lengths.at("flat"), 2. * R) < 1e-12);
          BOOST_TEST(p.low.distance({0., 0.}) < 1e-14);
          BOOST_TEST(p.high[0] == 2. * R);
          BOOST_TEST(p.high[1] <= R * (1. + 1e-14));
        }
}



BOOST_AUTO_TEST_CASE(half_disc_is_not_folded)
{
  for (const double angle : {30., 60., 90., 150.})
    for (const double radii : {2., 8., 1000.})
      for (const unsigned int sectors : {4, 8})
        for (const unsigned int degree : {1, 2, 3})
          {
            const auto mesh =
              make_section_mesh(half_disc(angle, radii, sectors), constants);
            BOOST_TEST(smallest_jacobian(mesh, degree) > 0.05,
                       "angle " << angle << ", R / finest " << radii << ", "
                                << sectors << " sectors, LE-" << degree << ": "
                                << smallest_jacobian(mesh, degree));
          }
}



BOOST_AUTO_TEST_CASE(half_disc_is_graded)
{
  // The cells at P are as wide as asked for, where there is room for rings, and
  // all cells are about as wide as deep.
  for (const double angle : {45., 90., 150.})
    for (const double radii : {20., 500.})
      {
        const HalfDisc disc = half_disc(angle, radii);
        const auto     mesh = make_section_mesh(disc, constants);
        const Point<2> P(R + R * std::cos(angle * PI / 180.),
                         R * std::sin(angle * PI / 180.));
        unsigned int   at_P = 0;
        for (const auto &cell : mesh->mesh.active_cell_iterators())
          {
            double shortest = 10., longest = 0.;
            for (const unsigned int f : cell->face_indices())
              {
                const double l = cell->face(f)->diameter();
                shortest       = std::min(shortest, l);
                longest        = std::max(longest, l);
                if (cell->face(f)->at_boundary() &&
                    (cell->face(f)->vertex(0).distance(P) < 1e-9 ||
                     cell->face(f)->vertex(1).distance(P) < 1e-9))
                  {
                    ++at_P;
                    BOOST_TEST(off(l, disc.finest_cell) < 0.05);
                  }
              }
            BOOST_TEST(longest < 7. * shortest);
          }
        BOOST_TEST(at_P == 2);
      }
}



BOOST_AUTO_TEST_CASE(area_converges_with_the_degree)
{
  // The geometry is interpolated in the element's nodes: on a circle the error
  // falls by a decade or more a degree.
  for (const bool ellipse : {false, true})
    {
      const auto mesh =
        ellipse ? make_section_mesh(Ellipse{2., 1., 1, carbon}, constants) :
                  make_section_mesh(half_disc(90., 8., 8), constants);
      const double exact    = ellipse ? PI / 2. : PI * R * R / 2.;
      double       previous = 1.;
      for (const unsigned int degree : {1, 2, 3, 4})
        {
          const double error = off(make_section(mesh, degree)->area(), exact);
          BOOST_TEST_MESSAGE("LE-" << degree << ": area off by " << error);
          BOOST_TEST(error < 0.2 * previous);
          previous = error;
        }
      BOOST_TEST(previous < 1e-6);
    }
}



BOOST_AUTO_TEST_CASE(cells_are_divided)
{
  // Four for one, on the same curve: LE-1's area, a polygon's, is four times
  // closer, and sides, plies and what lies in them stay.
  for (const bool ellipse : {false, true})
    {
      const auto mesh =
        ellipse ? make_section_mesh(Ellipse{2., 1., 2, carbon}, constants) :
                  make_section_mesh(half_disc(90., 8., 8), constants);
      const auto fine = divided(*mesh, 1, "Section s");
      check_section_mesh(*fine, {"Section s", ""});
      BOOST_TEST(fine->mesh.n_levels() == 1u);
      BOOST_TEST(fine->mesh.n_active_cells() ==
                 4 * mesh->mesh.n_active_cells());
      const double exact = ellipse ? PI / 2. : PI * R * R / 2.,
                   ratio = off(make_section(mesh, 1)->area(), exact) /
                           off(make_section(fine, 1)->area(), exact);
      BOOST_TEST(std::abs(ratio - 4.) < 0.1);
      BOOST_TEST((fine->boundaries == mesh->boundaries));
    }
  const Laminate two{
    2., {0., 90.}, {0.25, 0.75}, {"carbon", "foam"}, {1}, {3}, {}};
  const auto fine = divided(*make_section_mesh(two, constants), 2, "");
  BOOST_TEST(fine->mesh.n_active_cells() == 96u);
  BOOST_TEST(fine->plies.size() == 2u);
  const SectionProperties p = section_properties(*fine);
  BOOST_TEST(off(p.ply_areas.at(0), 0.5) < 1e-13);
  BOOST_TEST(off(p.ply_areas.at(1), 1.5) < 1e-13);
  BOOST_TEST(off(p.boundary_lengths.at("top"), 2.) < 1e-14);
  BOOST_CHECK_THROW(divided(*fine, 5, "Section s"), InputError);
}



BOOST_AUTO_TEST_CASE(corners_without_a_limit)
{
  // One in an angle, two in a tee, four in a double-T, a box has those inside;
  // of plies the ends of interfaces between those that differ.
  for (const auto &[form, corners] : {std::make_pair(ShapeKind::angle, 1u),
                                      {ShapeKind::t, 2u},
                                      {ShapeKind::channel, 2u},
                                      {ShapeKind::double_t, 4u},
                                      {ShapeKind::box, 4u}})
    {
      const bool is_angle = form == ShapeKind::angle;
      const auto mesh     = make_section_mesh(
        walls(form,
              form == ShapeKind::box ? std::vector<double>{0.5, 0.5} :
                                           std::vector<double>{0.5},
              is_angle || form == ShapeKind::t ? std::vector<double>{0.4} :
                                                     std::vector<double>{0.4, 0.4}),
        constants);
      BOOST_TEST(singular_corners(*mesh).size() == corners, name_of(form));
    }
  const auto laminate = [](const std::vector<double> &angles) {
    const std::vector<double>      thicknesses(angles.size(), 0.25);
    const std::vector<std::string> materials(angles.size(), "carbon");
    return make_section_mesh(
      Laminate{2., angles, thicknesses, materials, {1}, {3}, {}}, constants);
  };
  BOOST_TEST(singular_corners(*laminate({45., -45., 0.})).size() == 4u);
  BOOST_TEST(singular_corners(*laminate({0., 0.})).empty());
  BOOST_CHECK_THROW(graded_to_corners(*laminate({0., 0.}), 1, "Section s"),
                    InputError);
}



BOOST_AUTO_TEST_CASE(layers_at_corners)
{
  // Areas, moments and sides stay; cells match, and those at a corner are
  // 0.15^2 of what was there.
  const auto mesh =
    make_section_mesh(walls(ShapeKind::double_t, {0.5}, {0.4, 0.4}), constants);
  const auto fine = graded_to_corners(*mesh, 2, "Section s");
  check_section_mesh(*fine, {"Section s", ""});
  const SectionProperties coarse = section_properties(*mesh),
                          graded = section_properties(*fine);
  BOOST_TEST(off(graded.area, coarse.area) < 1e-13);
  for (const unsigned int i : {0u, 1u})
    BOOST_TEST(off(graded.second_moments[i][i], coarse.second_moments[i][i]) <
               1e-12);
  for (const auto &[side, length] : coarse.boundary_lengths)
    BOOST_TEST(off(graded.boundary_lengths.at(side), length) < 1e-13, side);
  const auto smallest = [](const SectionMesh &section) {
    double edge = 1e300;
    for (const auto &face : section.mesh.active_face_iterators())
      edge = std::min(edge, face->measure());
    return edge;
  };
  BOOST_TEST(off(smallest(*fine), 0.0225 * smallest(*mesh)) < 1e-12);
  BOOST_TEST(singular_corners(*fine).size() == 4u);
  // 47,700 cells become more than a section may have.
  ThinWalled many       = walls(ShapeKind::double_t, {0.5}, {0.4, 0.4});
  many.cells_per_wall   = 60;
  many.cells_along_wall = 135;
  BOOST_CHECK_THROW(graded_to_corners(*make_section_mesh(many, constants),
                                      6,
                                      "Section s"),
                    InputError);
}



BOOST_AUTO_TEST_CASE(torsion_of_an_L)
{
  // Three unit squares: J = 4 int u with -Laplace u = 1 and u = 0 at the
  // boundary, for which adaptive meshes have int u = 0.2140758. The re-entrant
  // corner holds equal cells back to p^(-8/3); a layer more with each degree
  // takes the error by a constant factor.
  const double exact = 4. * 0.2140758;
  const double G     = constants.at("carbon").elastic.stiffness()[3][3];
  const auto   mesh  = make_section_mesh(
    ThinWalled{ShapeKind::angle, 2., 2., {1.}, {1.}, 1, 1, {"carbon", 0.}},
    constants);
  BOOST_TEST(mesh->mesh.n_active_cells() == 3u);
  const auto error = [&](const std::shared_ptr<const SectionMesh> &section,
                         const unsigned int                        degree) {
    const double J =
      *torsional_stiffness(*make_section(section, Theory::layerwise(degree))) /
      G;
    return J / exact - 1.;
  };
  const auto graded = [&](const unsigned int layers) {
    return graded_to_corners(*mesh, layers, "Section s");
  };
  double before = error(mesh, 2);
  for (const unsigned int layers : {1u, 2u})
    {
      const double now = error(graded(layers), layers + 2);
      BOOST_TEST_MESSAGE(layers << " layers, LE-" << layers + 2 << ": " << now
                                << ", none: " << error(mesh, layers + 2));
      BOOST_TEST(now > 0.);
      BOOST_TEST(now < 0.3 * before);
      before = now;
    }
  BOOST_TEST(before < 0.05 * error(mesh, 4));
}



BOOST_AUTO_TEST_CASE(ellipse_against_closed_forms)
{
  for (const auto &[width, height] :
       std::vector<std::pair<double, double>>{{3., 1.}, {1., 1.}, {1., 20.}})
    {
      const auto mesh =
        make_section_mesh(Ellipse{width, height, 2, carbon}, constants);
      check_section_mesh(*mesh, {"Section s", ""});
      BOOST_TEST(mesh->mesh.n_active_cells() == 192);
      const SectionProperties p = section_properties(*mesh);
      const double            a = width / 2., b = height / 2.;
      BOOST_TEST(off(p.area, PI * a * b) < 1e-10);
      BOOST_TEST(p.centroid.distance({a, b}) < 1e-12);
      BOOST_TEST(off(p.second_moments[0][0], PI * a * a * a * b / 4.) < 1e-10);
      BOOST_TEST(off(p.second_moments[1][1], PI * a * b * b * b / 4.) < 1e-10);
      if (width == height)
        BOOST_TEST(off(p.boundary_lengths.at("arc"), 2. * PI * a) < 1e-10);
      for (const unsigned int degree : {1, 2, 3})
        BOOST_TEST(smallest_jacobian(mesh, degree) > 0.1);
    }
}



BOOST_AUTO_TEST_CASE(thin_walled_against_closed_forms)
{
  // In a box of 3 x 4, as sums of rectangles.
  struct Case
  {
    ThinWalled             shape;
    std::vector<Rectangle> rectangles;
    unsigned int           cells;
    /// left, right, bottom, top, inner.
    std::vector<double> lengths;
  };
  // Blocks of 2 x 2 cells where walls meet, of 2 x 3 along a wall.
  const std::vector<Case> cases{
    {walls(ShapeKind::box, {0.3, 0.5}, {0.2, 0.4}),
     {{0., 3., 0., 4., 1.}, {0.3, 2.5, 0.2, 3.6, -1.}},
     40,
     {4., 4., 3., 3., 2. * (2.2 + 3.4)}},
    {walls(ShapeKind::double_t, {0.4}, {0.2, 0.6}),
     {{0., 3., 0., 0.2, 1.}, {0., 3., 3.4, 4., 1.}, {1.3, 1.7, 0.2, 3.4, 1.}},
     38,
     {0.8, 0.8, 3., 3., 2. * 3.2 + 4. * 1.3}},
    {walls(ShapeKind::t, {0.4}, {0.6}),
     {{0., 3., 3.4, 4., 1.}, {1.3, 1.7, 0., 3.4, 1.}},
     22,
     {0.6, 0.6, 0.4, 3., 2. * 3.4 + 2.6}},
    {walls(ShapeKind::channel, {0.4}, {0.2, 0.6}),
     {{0., 3., 0., 4., 1.}, {0.4, 3., 0.2, 3.4, -1.}},
     26,
     {4., 0.8, 3., 3., 2. * 2.6 + 3.2}},
    {walls(ShapeKind::angle, {0.4}, {0.6}),
     {{0., 3., 0., 4., 1.}, {0.4, 3., 0.6, 4., -1.}},
     16,
     {4., 0.6, 3., 0.4, 2.6 + 3.4}}};
  for (const Case &one : cases)
    {
      const std::string form = name_of(SectionShape(one.shape));
      BOOST_TEST_INFO(form);
      const auto mesh = make_section_mesh(one.shape, constants);
      check_section_mesh(*mesh, {"Section s", ""});
      const SectionProperties p = section_properties(*mesh);
      const Rectangles        r = sum_of(one.rectangles);
      BOOST_TEST(mesh->mesh.n_active_cells() == one.cells, form);
      BOOST_TEST(off(p.area, r.area) < 1e-13, form);
      BOOST_TEST(p.centroid.distance(r.centroid) < 1e-13);
      BOOST_TEST(off(p.second_moments[0][0], r.moments[0][0]) < 1e-12);
      BOOST_TEST(off(p.second_moments[1][1], r.moments[1][1]) < 1e-12);
      BOOST_TEST(std::abs(p.second_moments[0][1] - r.moments[0][1]) < 1e-12);
      const std::array<const char *, 5> names{
        {"left", "right", "bottom", "top", "inner"}};
      for (unsigned int i = 0; i < 5; ++i)
        BOOST_TEST(off(p.boundary_lengths.at(names[i]), one.lengths[i]) < 1e-12,
                   form << ": " << names[i]);
      BOOST_TEST(mesh->plies.size() == 1);
      BOOST_TEST(mesh->plies[0].angle == 30.);
      BOOST_TEST((named<ShapeKind>(form) == one.shape.form));
    }
}



BOOST_AUTO_TEST_CASE(edges_are_whole_and_normals_point_outwards)
{
  // The integral of n over the whole boundary vanishes, that of x . n is twice
  // the area (Gauss), and the lengths are those of the shapes.
  const std::vector<SectionShape> shapes{
    half_disc(60., 8., 12),
    Ellipse{2., 2., 2, carbon},
    walls(ShapeKind::box, {0.3, 0.5}, {0.2, 0.4}),
    walls(ShapeKind::channel, {0.4}, {0.2, 0.6}),
    SectionFile{folder + "/prm/sections/hexagon.msh", 1., {}, "Section s"}};
  for (const SectionShape &shape : shapes)
    for (const unsigned int degree : {1, 2, 3})
      {
        const auto            mesh = make_section_mesh(shape, constants);
        const LagrangeElement element(mesh, degree);
        Tensor<1, 2>          normal;
        double                flux = 0.;
        for (const auto &[id, name] : mesh->boundaries)
          {
            const Edge e = edge(element, name);
            normal += e.normal;
            flux += e.flux;
            double nodal = 0.;
            for (const EdgePoint &p : element.edge_points(name))
              nodal += p.weight;
            BOOST_TEST(off(nodal, e.length) < (degree < 3 ? 1e-2 : 1e-3));
          }
        BOOST_TEST(normal.norm() < 1e-12 * std::abs(flux));
        BOOST_TEST(off(flux, 2. * make_section(mesh, degree)->area()) < 1e-12);
      }
  // LE-3 on the arcs.
  const LagrangeElement disc(make_section_mesh(shapes[0], constants), 3),
    circle(make_section_mesh(shapes[1], constants), 3);
  BOOST_TEST(off(edge(disc, "arc").length, PI * R) < 1e-4);
  BOOST_TEST(off(edge(disc, "flat").length, 2. * R) < 1e-13);
  BOOST_TEST(off(edge(circle, "arc").length, 2. * PI) < 1e-5);
  for (const EdgePoint &p : edge_quadrature(disc, "arc", 3))
    BOOST_TEST(std::abs(p.position.distance({R, 0.}) - R) < 2e-3 * R);
}



BOOST_AUTO_TEST_CASE(hollow_hexagon_by_gmsh)
{
  // Of a regular hexagon with the side a: A = 3 sqrt(3) / 2 a^2,
  // I = 5 sqrt(3) / 16 a^4 about any axis through its center.
  const double      a = 10., b = 10. - 2. / std::cos(PI / 6.);
  const SectionFile file{folder + "/prm/sections/hexagon.msh",
                         0.1,
                         {},
                         "Section s"};
  const auto        mesh = make_section_mesh(file, constants);
  const auto        p    = section_properties(*mesh);
  BOOST_TEST(mesh->mesh.n_active_cells() == 36);
  BOOST_TEST(off(p.area, 0.01 * 1.5 * std::sqrt(3.) * (a * a - b * b)) < 1e-12);
  const double I =
    1e-4 * 5. * std::sqrt(3.) / 16. * (std::pow(a, 4) - std::pow(b, 4));
  BOOST_TEST(off(p.second_moments[0][0], I) < 1e-12);
  BOOST_TEST(off(p.second_moments[1][1], I) < 1e-12);
  // The file's coordinates stay: the center at z = 0.
  BOOST_TEST(p.centroid.distance({1., 0.}) < 1e-12);
  BOOST_TEST(off(-p.low[1], std::sqrt(0.75)) < 1e-12);
  BOOST_TEST(p.boundary_lengths.size() == 4);
  BOOST_TEST(off(p.boundary_lengths.at("top"), 1.) < 1e-12);
  BOOST_TEST(off(p.boundary_lengths.at("inside"), 0.6 * b) < 1e-12);
  BOOST_TEST(mesh->plies.size() == 1);
  BOOST_TEST(mesh->plies[0].material == "carbon");
  BOOST_TEST(off(mesh->plies[0].top, std::sqrt(0.75)) < 1e-12);
}



BOOST_AUTO_TEST_CASE(parts_of_a_mesh_by_gmsh)
{
  const SectionFile file{folder + "/prm/sections/sandwich.msh",
                         1.,
                         {{"skin", {"carbon", 45.}}, {"core", {"foam", 0.}}},
                         "Section s"};
  const auto        mesh = make_section_mesh(file, constants);
  const auto        p    = section_properties(*mesh);
  BOOST_TEST_REQUIRE(mesh->plies.size() == 2);
  for (unsigned int i = 0; i < 2; ++i)
    {
      const bool skin = mesh->plies[i].material == "carbon";
      BOOST_TEST(mesh->plies[i].angle == (skin ? 45. : 0.));
      BOOST_TEST(off(p.ply_areas[i], skin ? 480. - 304. : 304.) < 1e-12);
      BOOST_TEST(std::abs(mesh->plies[i].bottom - (skin ? 0. : 2.)) < 1e-12);
      BOOST_TEST(std::abs(mesh->plies[i].top - (skin ? 12. : 10.)) < 1e-12);
    }
  for (const auto &cell : mesh->mesh.active_cell_iterators())
    {
      const Point<2> c    = cell->center();
      const bool     core = c[0] < 38. && c[1] > 2. && c[1] < 10.;
      BOOST_TEST((mesh->plies[cell->material_id()].material == "foam") == core);
    }
  // Without Parts the names are no materials.
  SectionFile without = file;
  without.parts       = {};
  BOOST_CHECK_THROW(make_section_mesh(without, constants), InputError);
}



BOOST_AUTO_TEST_CASE(unstructured_mesh_by_gmsh)
{
  // Web and flanges, and four times what a square of the radius has beyond a
  // quarter of a disc; Gmsh's sides of cells are straight.
  const auto mesh = make_section_mesh(
    SectionFile{folder + "/prm/sections/rail.msh", 1., {}, "Section s"},
    constants);
  const auto p = section_properties(*mesh);
  BOOST_TEST(off(p.area, 168. + 4. * 9. * (1. - PI / 4.)) < 0.02);
  BOOST_TEST(p.centroid.distance({10., 15.}) < 0.02);
  BOOST_TEST(off(p.boundary_lengths.at("top"), 20.) < 1e-12);
  BOOST_TEST(p.boundary_lengths.count("other") == 1);
}



BOOST_AUTO_TEST_CASE(cells_clockwise)
{
  // One of the two cells clockwise, no physical line: it is turned, and the
  // boundary is `other`.
  const auto mesh =
    make_section_mesh(SectionFile{folder + "/tests/unit/meshes/clockwise.msh",
                                  1.,
                                  {{"ply", {"carbon", 0.}}},
                                  "Section s"},
                      constants);
  const auto p = section_properties(*mesh);
  BOOST_TEST(off(p.area, 2.) < 1e-13);
  BOOST_TEST(p.boundary_lengths.size() == 1);
  BOOST_TEST(off(p.boundary_lengths.at("other"), 6.) < 1e-13);
}



BOOST_AUTO_TEST_CASE(groups_that_run_backwards)
{
  // Physical Surface = {-1} and Physical Curve = {-3} have negative tags.
  const auto mesh =
    make_section_mesh(SectionFile{folder + "/tests/unit/meshes/backwards.msh",
                                  1.,
                                  {},
                                  "Section s"},
                      constants);
  const auto p = section_properties(*mesh);
  BOOST_TEST(off(p.ply_areas.at(0), 2.) < 1e-13);
  BOOST_TEST(off(p.boundary_lengths.at("top"), 2.) < 1e-13);
  BOOST_TEST(off(p.boundary_lengths.at("other"), 4.) < 1e-13);
}



BOOST_AUTO_TEST_CASE(entries_of_the_shapes)
{
  const std::vector<std::string> materials{"carbon", "foam"};
  const auto                     read = [&materials](const Settings &settings) {
    return parsed<SectionParameters>("Section s",
                                     settings,
                                     materials,
                                     "folder");
  };
  const auto disc = std::get<HalfDisc>(read({{"Shape", "half disc"},
                                             {"Radius", "4"},
                                             {"Material", "foam"},
                                             {"Fiber angle", "-20"}}));
  BOOST_TEST(disc.radius == 4.);
  BOOST_TEST(disc.finest_cell == 0.5);
  BOOST_TEST(disc.graded_towards == 90.);
  BOOST_TEST(disc.sectors == 8);
  BOOST_TEST(disc.oriented_material.material == "foam");
  BOOST_TEST(disc.oriented_material.angle == -20.);

  const auto box =
    std::get<ThinWalled>(read({{"Shape", "box"},
                               {"Width", "4"},
                               {"Height", "3"},
                               {"Wall thickness", "0.1, 0.2, 0.3, 0.4"},
                               {"Material", "foam"}}));
  BOOST_TEST(box.webs == (std::vector<double>{0.1, 0.2}),
             boost::test_tools::per_element());
  BOOST_TEST(box.flanges == (std::vector<double>{0.3, 0.4}),
             boost::test_tools::per_element());

  const auto tee = std::get<ThinWalled>(read({{"Shape", "double-T"},
                                              {"Width", "4"},
                                              {"Height", "3"},
                                              {"Wall thickness", "0.1"},
                                              {"Flange thickness", "0.2"},
                                              {"Material", "foam"}}));
  BOOST_TEST(tee.webs == std::vector<double>{0.1},
             boost::test_tools::per_element());
  BOOST_TEST(tee.flanges == (std::vector<double>{0.2, 0.2}),
             boost::test_tools::per_element());

  const auto file =
    std::get<SectionFile>(read({{"Shape", "file"},
                                {"File", "beam.msh"},
                                {"Parts", "web: carbon 45 | flange: foam"},
                                {"Scale", "0.001"}}));
  BOOST_TEST(file.path == "folder/beam.msh");
  BOOST_TEST(file.scale == 0.001);
  BOOST_TEST(file.parts.at("web").material == "carbon");
  BOOST_TEST(file.parts.at("web").angle == 45.);
  BOOST_TEST(file.parts.at("flange").material == "foam");
  BOOST_TEST(file.parts.at("flange").angle == 0.);
}



BOOST_AUTO_TEST_CASE(laminate_of_pieces_and_unequal_plies)
{
  // Three pieces across of 2, 4 and 1 cells, plies of 1 and 3 cells.
  const Laminate laminate{1.,
                          {0., 90.},
                          {0.1, 0.3},
                          {"foam", "carbon"},
                          {1, 3},
                          {2, 4, 1},
                          {0.2, 0.6}};
  const auto     mesh = make_section_mesh(laminate, constants);
  BOOST_TEST(mesh->mesh.n_active_cells() == 7 * 4);
  std::map<int, unsigned int> widths;
  for (const auto &cell : mesh->mesh.active_cell_iterators())
    {
      const double w = cell->vertex(1)[0] - cell->vertex(0)[0],
                   x = cell->center()[0];
      BOOST_TEST(off(w, x < 0.6 ? 0.1 : 0.4) < 1e-12);
      BOOST_TEST(off(cell->vertex(2)[1] - cell->vertex(0)[1], 0.1) < 1e-12);
      BOOST_TEST(cell->material_id() == (cell->center()[1] < 0.1 ? 0u : 1u));
    }
}



BOOST_AUTO_TEST_CASE(table_for_pictures)
{
  const auto mesh  = make_section_mesh(half_disc(), constants);
  const auto table = section_table(*mesh);
  const auto count = [&table](const std::string &what) {
    unsigned int n = 0;
    for (auto at = table.find(what); at != std::string::npos;
         at      = table.find(what, at + 1))
      ++n;
    return n;
  };
  BOOST_TEST(count("\n") == mesh->mesh.n_active_cells() + 1);
  BOOST_TEST(count("flat") == 8);
  // 12 edges on the arc: 4 of the core, 2 on each side in the rings and the
  // rest each; nine points where eight ';' part them, one where side are
  // straight.
  BOOST_TEST(count(",arc") == 12);
  BOOST_TEST(count(";") == 12 * 8 + (4 * mesh->mesh.n_active_cells() - 12));
}

BOOST_AUTO_TEST_SUITE_END()
