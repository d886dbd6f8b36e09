// SPDX-License-Identifier: LGPL-2.1-or-later

// The section: its matrices S_pq against integrals by hand, the places of
// points, the points on its edges with their weights, and the span of the
// Lagrange expansion.

#include "fixtures.h"

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/grid/grid_tools.h>

#include <deal.II/lac/full_matrix.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

BOOST_AUTO_TEST_SUITE(section)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const EngineeringConstants
    orthotropic{165., 9., 8., 5.6, 5.2, 2.8, 0.34, 0.3, 0.45};

  // E = 10, nu = 0.25: lambda = mu = 4, lambda + 2 mu = 12.
  const EngineeringConstants isotropic =
    EngineeringConstants::isotropic(10., 0.25);
  constexpr double lambda = 4., mu = 4., stiff = 12.;

  // Half the diagonal of 0.6 x 0.8 is h = 0.5.
  constexpr double width = 0.6, height = 0.8, h = 0.5, area = 0.48;



  /// 3 x 4 cells in two plies with the inner vertices moved.
  std::shared_ptr<const SectionMesh>
  distorted_mesh()
  {
    const auto regular =
      make_section_mesh(rectangle(width, height, {20., -35.}, 3, 2),
                        {{"material", orthotropic}});
    auto mesh = std::make_shared<SectionMesh>();
    mesh->mesh.copy_triangulation(regular->mesh);
    mesh->plies      = regular->plies;
    mesh->boundaries = regular->boundaries;
    dealii::GridTools::distort_random(0.25, mesh->mesh, true, 3);
    return mesh;
  }



  std::shared_ptr<const SectionMesh>
  regular_mesh(const unsigned int across, const unsigned int up)
  {
    return make_section_mesh(rectangle(width, height, {0.}, across, up),
                             {{"material", isotropic}});
  }



  /// The value of the expansion with the coefficients @p a.
  double
  value(const LagrangeElement        &element,
        const dealii::Vector<double> &a,
        const unsigned int            cell,
        const Point<2>               &unit,
        Tensor<1, 2>                 &gradient)
  {
    const FunctionValues at  = element.evaluate(cell, unit);
    const auto          &tau = element.cell_functions(cell);
    double               sum = 0.;
    gradient                 = 0.;
    for (unsigned int k = 0; k < tau.size(); ++k)
      {
        sum += a[tau[k]] * at.values[k];
        gradient += a[tau[k]] * at.gradients[k];
      }
    return sum;
  }



  /// The inverse of F_tau(node), whose columns are the nodal functions in terms
  /// of the element's own.
  dealii::FullMatrix<double>
  nodal_basis(const LagrangeElement &element)
  {
    const auto                 nodes = element.section_points();
    dealii::FullMatrix<double> F(nodes.size(), element.n_functions());
    BOOST_TEST_REQUIRE(F.m() == F.n());
    for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        const FunctionValues at =
          element.evaluate(nodes[i].cell, nodes[i].unit);
        BOOST_TEST((at.position - nodes[i].position).norm() < 1e-14);
        const auto &tau = element.cell_functions(nodes[i].cell);
        for (unsigned int k = 0; k < tau.size(); ++k)
          F(i, tau[k]) = at.values[k];
      }
    F.gauss_jordan();
    return F;
  }



  const std::vector<Point<2>> places{{0.1, 0.2},
                                     {0.9, 0.35},
                                     {0.5, 0.77},
                                     {0., 0.6},
                                     {0.3, 1.}};
} // namespace

BOOST_AUTO_TEST_CASE(number_and_names_of_functions)
{
  // 4 x 3 cells: (4 p + 1)(3 p + 1) nodes.
  const std::vector<std::string>  names{"LE-1 (L4)", "LE-2 (L9)", "LE-3 (L16)"};
  const std::vector<unsigned int> functions{20, 63, 130};
  for (unsigned int p = 1; p <= 3; ++p)
    {
      const LagrangeElement element(regular_mesh(4, 3), p);
      BOOST_TEST(element.n_functions() == functions[p - 1]);
      BOOST_TEST(layer_wise(p).name() == names[p - 1]);
      BOOST_TEST(element.degree() == p);
      BOOST_TEST(make_section(regular_mesh(4, 3), p)->n_fields() ==
                 3 * functions[p - 1]);
    }
}



BOOST_AUTO_TEST_CASE(first_functions_are_the_linear_ones)
{
  for (const auto &mesh : {regular_mesh(2, 2), distorted_mesh()})
    for (const unsigned int p : {1, 2, 3})
      {
        const LagrangeElement element(mesh, p);
        const Point<2>        c = element.center();
        BOOST_TEST(element.reference_length() == h);
        for (unsigned int cell = 0; cell < mesh->mesh.n_active_cells(); ++cell)
          for (const Point<2> &unit : places)
            {
              const FunctionValues at  = element.evaluate(cell, unit);
              const auto          &tau = element.cell_functions(cell);
              BOOST_TEST(tau[0] == 0);
              BOOST_TEST(tau[1] == 1);
              BOOST_TEST(tau[2] == 2);
              BOOST_TEST(std::is_sorted(tau.begin(), tau.end()));
              BOOST_TEST(at.values[0] == 1.);
              BOOST_TEST(std::abs(at.values[1] - (at.position[0] - c[0]) / h) <
                         1e-14);
              BOOST_TEST(std::abs(at.values[2] - (at.position[1] - c[1]) / h) <
                         1e-14);
              BOOST_TEST(at.gradients[0].norm() == 0.);
              BOOST_TEST((at.gradients[1] - Point<2>(2., 0.)).norm() < 1e-14);
              BOOST_TEST((at.gradients[2] - Point<2>(0., 2.)).norm() < 1e-14);
            }
      }
}



BOOST_AUTO_TEST_CASE(center_of_area)
{
  // That of the rectangle, (0.3, 0.4), however it is cut into cells.
  const LagrangeElement regular(regular_mesh(3, 2), 2);
  BOOST_TEST(regular.center().distance({0.3, 0.4}) < 1e-14);
  const LagrangeElement distorted(distorted_mesh(), 2);
  BOOST_TEST(distorted.center().distance({0.3, 0.4}) < 1e-14);
}



BOOST_AUTO_TEST_CASE(span_is_that_of_the_nodal_functions)
{
  // The nodal function of a node is 1 there and the shape function of FE_Q on
  // the cells around it, 0 elsewhere.
  for (const unsigned int p : {1, 2, 3})
    {
      const auto            mesh = distorted_mesh();
      const LagrangeElement element(mesh, p);
      const auto            nodes = element.section_points();
      const auto            basis = nodal_basis(element);
      const dealii::FE_Q<2> fe(p);
      double                worst = 0.;
      for (unsigned int node = 0; node < nodes.size(); ++node)
        {
          dealii::Vector<double> a(element.n_functions());
          for (unsigned int tau = 0; tau < a.size(); ++tau)
            a[tau] = basis(tau, node);
          for (unsigned int cell = 0; cell < mesh->mesh.n_active_cells();
               ++cell)
            for (const Point<2> &unit : places)
              {
                double expected = 0.;
                for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
                  if (element.evaluate(cell, fe.unit_support_point(i))
                        .position.distance(nodes[node].position) < 1e-10)
                    expected = fe.shape_value(i, unit);
                Tensor<1, 2> gradient;
                worst =
                  std::max(worst,
                           std::abs(value(element, a, cell, unit, gradient) -
                                    expected));
              }
        }
      BOOST_TEST(worst < 1e-11, "LE-" << p << ": error " << worst);
    }
}



BOOST_AUTO_TEST_CASE(polynomials_are_interpolated_exactly)
{
  // With degree 2 the monomials up to x^2 z^2 are in the span on rectangular
  // cells, those of total degree 2 on any straight ones (x and z are bilinear
  // in the place on the cell), with their gradients.
  for (const bool distorted : {false, true})
    {
      const LagrangeElement element(distorted ? distorted_mesh() :
                                                regular_mesh(3, 2),
                                    2);
      const auto nodes = element.section_points();
      const auto basis = nodal_basis(element);
      for (const auto &[m, n] : std::vector<std::pair<int, int>>{
             {1, 0}, {0, 1}, {1, 1}, {2, 0}, {0, 2}, {2, 1}, {1, 2}, {2, 2}})
        {
          if (distorted && m + n > 2)
            continue;
          const auto f = [m = m, n = n](const Point<2> &x) {
            return std::pow(x[0], m) * std::pow(x[1], n);
          };
          const auto grad_f = [m = m, n = n](const Point<2> &x) {
            return Point<2>(
              m == 0 ? 0. : m * std::pow(x[0], m - 1) * std::pow(x[1], n),
              n == 0 ? 0. : n * std::pow(x[0], m) * std::pow(x[1], n - 1));
          };
          dealii::Vector<double> at_nodes(nodes.size()), a(nodes.size());
          for (unsigned int i = 0; i < nodes.size(); ++i)
            at_nodes[i] = f(nodes[i].position);
          basis.vmult(a, at_nodes);
          double      error = 0.;
          const auto &mesh  = element.section_mesh().mesh;
          for (unsigned int cell = 0; cell < mesh.n_active_cells(); ++cell)
            for (const Point<2> &unit : places)
              {
                Tensor<1, 2> gradient;
                const double found = value(element, a, cell, unit, gradient);
                const auto   x     = element.evaluate(cell, unit).position;
                error              = std::max({error,
                                               std::abs(found - f(x)),
                                               (gradient - grad_f(x)).norm()});
              }
          BOOST_TEST(error < 1e-11,
                     "x^" << m << " z^" << n << ": error " << error);
        }
    }
}



BOOST_AUTO_TEST_CASE(area_is_that_of_the_rectangle)
{
  for (const unsigned int p : {1, 2, 3})
    {
      BOOST_TEST(std::abs(make_section(distorted_mesh(), p)->area() - area) <
                 1e-14);
      BOOST_TEST(std::abs(make_section(regular_mesh(2, 3), p)->area() - area) <
                 1e-14);
    }
}



BOOST_AUTO_TEST_CASE(matrices_are_symmetric_as_stated)
{
  for (const unsigned int p : {1, 2})
    {
      const auto section = make_section(distorted_mesh(), p);
      double     worst = 0., largest = 0.;
      for (unsigned int a = 0; a < section->n_fields(); ++a)
        for (unsigned int b = 0; b < section->n_fields(); ++b)
          {
            const auto S = [&](const unsigned int q, const unsigned int r) {
              return std::make_pair(section->S(q, r).el(a, b),
                                    section->S(r, q).el(b, a));
            };
            for (const auto &[one, other] : {S(0, 0), S(0, 1), S(1, 1)})
              {
                worst   = std::max(worst, std::abs(one - other));
                largest = std::max(largest, std::abs(one));
              }
          }
      BOOST_TEST(worst < 1e-14 * largest);
      // S_01 is not zero, and not symmetric in itself.
      BOOST_TEST(section->S(0, 1).frobenius_norm() > 1.);
    }
}



BOOST_AUTO_TEST_CASE(matrices_of_an_isotropic_rectangle)
{
  // The fields: 0, 1, 2 translations, 3: u_y = X, 4: u_y = Z, 5: u_x = Z,
  // u_z = -X, 6: u_x = X, 7: u_z = Z, 8: u_x = Z, u_z = X, where
  // X = (x - x_c)/h, Z = (z - z_c)/h. int X^2 = 0.6^3 0.8 / (12 h^2),
  // int Z^2 = 0.6 0.8^3 / (12 h^2).
  const double XX          = 0.216 * 0.8 / 12. / (h * h),
               ZZ          = 0.6 * 0.512 / 12. / (h * h);
  constexpr unsigned int n = 9;
  using Entries = std::map<std::pair<unsigned int, unsigned int>, double>;

  // D_y Phi is gamma_xy = u_x, eps_yy = u_y, gamma_yz = u_z.
  const Entries S11{{{0, 0}, mu * area},
                    {{1, 1}, stiff * area},
                    {{2, 2}, mu * area},
                    {{3, 3}, stiff * XX},
                    {{4, 4}, stiff * ZZ},
                    {{5, 5}, mu * (XX + ZZ)},
                    {{6, 6}, mu * XX},
                    {{7, 7}, mu * ZZ},
                    {{8, 8}, mu * (XX + ZZ)},
                    {{5, 8}, mu * (ZZ - XX)},
                    {{8, 5}, mu * (ZZ - XX)}};
  // D_s Phi: 3: gamma_xy = 1/h, 4: gamma_yz = 1/h, 6: eps_xx = 1/h,
  // 7: eps_zz = 1/h, 8: gamma_xz = 2/h; none for 0, 1, 2, 5.
  const Entries S00{{{3, 3}, mu * area / (h * h)},
                    {{4, 4}, mu * area / (h * h)},
                    {{6, 6}, stiff * area / (h * h)},
                    {{7, 7}, stiff * area / (h * h)},
                    {{6, 7}, lambda * area / (h * h)},
                    {{7, 6}, lambda * area / (h * h)},
                    {{8, 8}, 4. * mu * area / (h * h)}};
  // Row D_s, column D_y; integrals of X and Z alone vanish.
  const Entries S01{{{3, 0}, mu * area / h},
                    {{4, 2}, mu * area / h},
                    {{6, 1}, lambda * area / h},
                    {{7, 1}, lambda * area / h}};

  for (const unsigned int p : {1, 2, 3})
    {
      const auto section = make_section(regular_mesh(2, 1), p);
      const auto check =
        [&](const Matrix &S, const Entries &expected, auto name) {
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int b = 0; b < n; ++b)
              {
                const auto   found = expected.find({a, b});
                const double due = found == expected.end() ? 0. : found->second;
                BOOST_TEST(std::abs(S.el(a, b) - due) < 1e-13,
                           name << "(" << a << ", " << b << ") = " << S.el(a, b)
                                << ", not " << due << ", LE-" << p);
              }
        };
      check(section->S(1, 1), S11, "S_11");
      check(section->S(0, 0), S00, "S_00");
      check(section->S(0, 1), S01, "S_01");
    }
}



BOOST_AUTO_TEST_CASE(translations_of_a_laminate)
{
  // int C_yy, int C_xy,xy, int C_yz,yz and the couplings, over two plies of
  // half the height: means of the two elasticities times the area.
  const auto          section = make_section(distorted_mesh(), 2);
  const ElasticTensor lower   = rotated(orthotropic.stiffness(), ply_axes(20.)),
                      upper = rotated(orthotropic.stiffness(), ply_axes(-35.));
  // The distortion moves the interface, but not far: use the true areas.
  double area_below = 0.;
  for (const auto &cell :
       section->element().section_mesh().mesh.active_cell_iterators())
    if (cell->material_id() == 0)
      area_below += cell->measure();
  constexpr unsigned int strain_of[3] = {3, 1, 5};
  for (unsigned int a = 0; a < 3; ++a)
    for (unsigned int b = 0; b < 3; ++b)
      {
        const unsigned int i = strain_of[a], j = strain_of[b];
        BOOST_TEST(std::abs(section->S(1, 1).el(a, b) -
                            area_below * lower[i][j] -
                            (area - area_below) * upper[i][j]) < 1e-12);
      }
}



BOOST_AUTO_TEST_CASE(locate_on_a_regular_mesh)
{
  // 3 x 2 cells of 0.2 x 0.4.
  const auto   section = make_section(regular_mesh(3, 2), 2);
  const double eps     = 1e-9;
  const auto   n       = [&](const double x, const double z) {
    return section->locate({x, z}, eps).size();
  };
  BOOST_TEST(n(0.07, 0.11) == 1);
  BOOST_TEST(n(0.2, 0.11) == 2); // a side between two cells
  BOOST_TEST(n(0.07, 0.4) == 2); // likewise
  BOOST_TEST(n(0.4, 0.4) == 4);  // an inner vertex
  BOOST_TEST(n(0.2, 0.) == 2);   // a vertex on an edge
  BOOST_TEST(n(0.1, 0.8) == 1);  // an edge
  BOOST_TEST(n(0.6, 0.8) == 1);  // a corner
  BOOST_TEST(n(0.6 + 1e-10, 0.8) == 1);
  BOOST_TEST(n(0.6 + 1e-8, 0.8) == 0);
  BOOST_TEST(n(0.1, -1e-8) == 0);
  BOOST_TEST(n(-1., 0.1) == 0);
  BOOST_TEST(n(0.3, 2.) == 0);

  // And the place: x = 0.07 is 0.35 of the first cell.
  const auto found = section->locate({0.07, 0.11}, eps);
  BOOST_TEST((found[0].second - Point<2>(0.35, 0.275)).norm() < 1e-13);
}



BOOST_AUTO_TEST_CASE(locate_on_a_distorted_mesh)
{
  for (const unsigned int p : {1, 2})
    {
      const auto         section = make_section(distorted_mesh(), p);
      const unsigned int n       = section->n_cells();
      for (unsigned int cell = 0; cell < n; ++cell)
        for (const Point<2> &unit :
             {Point<2>(0.1, 0.2), Point<2>(0.9, 0.35), Point<2>(0.5, 0.77)})
          {
            const Point<2> x     = section->evaluate(cell, unit).position;
            const auto     found = section->locate(x, 1e-9);
            BOOST_TEST_REQUIRE(found.size() == 1);
            BOOST_TEST(found[0].first == cell);
            BOOST_TEST((found[0].second - unit).norm() < 1e-10);
          }

      // On the sides: one cell at the boundary, two inside; at vertices all
      // that meet there. Each place is the point.
      const auto &mesh = section->element().section_mesh().mesh;
      for (const auto &face : mesh.active_face_iterators())
        {
          const Point<2> x     = face->center();
          const auto     found = section->locate(x, 1e-9);
          BOOST_TEST(found.size() == (face->at_boundary() ? 1 : 2));
          for (const auto &[cell, unit] : found)
            BOOST_TEST(section->evaluate(cell, unit).position.distance(x) <
                       1e-9);
        }
      std::vector<unsigned int> cells_at(mesh.n_vertices(), 0);
      for (const auto &cell : mesh.active_cell_iterators())
        for (const unsigned int v : cell->vertex_indices())
          ++cells_at[cell->vertex_index(v)];
      for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
        BOOST_TEST(section->locate(mesh.get_vertices()[v], 1e-9).size() ==
                   cells_at[v]);
      BOOST_TEST(section->locate({-0.001, 0.3}, 1e-9).empty());
      BOOST_TEST(section->locate({0.3, 0.801}, 1e-9).empty());
    }
}



BOOST_AUTO_TEST_CASE(edge_points_fix_the_trace)
{
  struct Side
  {
    std::string  name;
    double       length;
    Point<2>     normal;
    unsigned int cells;
  };
  const std::vector<Side> sides{{"left", height, {-1., 0.}, 4},
                                {"right", height, {1., 0.}, 4},
                                {"bottom", width, {0., -1.}, 3},
                                {"top", width, {0., 1.}, 3}};
  for (const unsigned int p : {1, 2, 3, 4})
    {
      const LagrangeElement element(distorted_mesh(), p);
      for (const Side &side : sides)
        {
          const auto points = element.edge_points(side.name);
          BOOST_TEST(points.size() == side.cells * p + 1);
          double sum = 0., first_moment = 0.;
          for (const EdgePoint &point : points)
            {
              BOOST_TEST(point.weight > 0.);
              BOOST_TEST((point.normal - side.normal).norm() < 1e-13);
              // On the side, where its cell says that it is.
              const Point<2> x    = point.position;
              const Point<2> base = side.name == "right" ? Point<2>(width, 0.) :
                                    side.name == "top" ? Point<2>(0., height) :
                                                         Point<2>();
              BOOST_TEST(std::abs((x - base) * side.normal) < 1e-14);
              BOOST_TEST(
                (element.evaluate(point.cell, point.unit).position - x).norm() <
                1e-14);
              sum += point.weight;
              first_moment += point.weight * (x[0] + x[1]);
            }
          BOOST_TEST(std::abs(sum - side.length) < 1e-14);
          // The weights integrate linear functions: int s ds = l^2/2 along the
          // side, and the distance of the side from the corner times l.
          const double offset = side.name == "right" ? width :
                                side.name == "top"   ? height :
                                                       0.;
          BOOST_TEST(std::abs(first_moment - side.length * side.length / 2. -
                              offset * side.length) < 1e-14);
        }
      BOOST_TEST(element.edge_points("nowhere").empty());
    }
}



BOOST_AUTO_TEST_CASE(weights_and_depths_by_hand)
{
  // L9 on 3 x 2 cells of 0.2 x 0.4: Simpson's 1/6, 4/6, 1/6 of 0.2 each; the
  // cells are 0.4 deep below the top and 0.2 deep behind the sides.
  const LagrangeElement element(regular_mesh(3, 2), 2);
  for (const EdgePoint &point : element.edge_points("top"))
    {
      const double place = point.position[0] / 0.1;
      const bool   end =
        point.position[0] < 1e-9 || point.position[0] > width - 1e-9;
      const bool   middle   = std::lround(place) % 2 == 1;
      const double expected = middle ? 0.8 / 6. : end ? 0.2 / 6. : 0.4 / 6.;
      BOOST_TEST(std::abs(point.weight - expected) < 1e-14);
      BOOST_TEST(std::abs(point.depth - 0.4) < 1e-14);
    }
  for (const EdgePoint &point : element.edge_points("left"))
    BOOST_TEST(std::abs(point.depth - 0.2) < 1e-14);

  // One L9: 1/36, 1/9 and 4/9 of the area.
  const LagrangeElement one(regular_mesh(1, 1), 2);
  for (const EdgePoint &point : one.section_points())
    {
      const bool x_middle = std::abs(point.position[0] - 0.3) < 1e-9,
                 z_middle = std::abs(point.position[1] - 0.4) < 1e-9;
      const double expected =
        (x_middle ? 4. : 1.) * (z_middle ? 4. : 1.) / 36. * area;
      BOOST_TEST(std::abs(point.weight - expected) < 1e-15);
    }
}



BOOST_AUTO_TEST_CASE(section_points_share_the_area)
{
  for (const unsigned int p : {1, 2, 3, 4})
    for (const auto &mesh : {distorted_mesh(), regular_mesh(3, 4)})
      {
        const LagrangeElement element(mesh, p);
        const auto            points = element.section_points();
        BOOST_TEST(points.size() == (3 * p + 1) * (4 * p + 1));
        double sum = 0.;
        for (const EdgePoint &point : points)
          sum += point.weight;
        BOOST_TEST(std::abs(sum - area) < 1e-14);
      }
}



BOOST_AUTO_TEST_CASE(edge_quadrature_integrates)
{
  // Two Gauss points a cell integrate cubics: int x^3 over [0, 0.6] on the top
  // is 0.6^4/4, int z^3 over [0, 0.8] on the left 0.8^4/4.
  const LagrangeElement element(distorted_mesh(), 2);
  double                top = 0., left = 0.;
  for (const EdgePoint &point : edge_quadrature(element, "top", 2))
    {
      top += point.weight * std::pow(point.position[0], 3);
      BOOST_TEST((point.normal - Point<2>(0., 1.)).norm() < 1e-14);
    }
  for (const EdgePoint &point : edge_quadrature(element, "left", 2))
    {
      left += point.weight * std::pow(point.position[1], 3);
      BOOST_TEST((point.normal - Point<2>(-1., 0.)).norm() < 1e-14);
    }
  BOOST_TEST(std::abs(top - std::pow(0.6, 4) / 4.) < 1e-15);
  BOOST_TEST(std::abs(left - std::pow(0.8, 4) / 4.) < 1e-15);
}

BOOST_AUTO_TEST_SUITE_END()
