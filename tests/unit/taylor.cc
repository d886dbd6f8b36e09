// SPDX-License-Identifier: LGPL-2.1-or-later

// The expansion functions of TE-N: orthonormal over the section by a rule of
// their own, all polynomials of degree N and no others, with the right
// derivatives and points. And LE built in columns: the same space as nodal LE.

#include "fixtures.h"

#include <lamella/shape/shapes.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/lac/householder.h>

#include <boost/test/unit_test.hpp>

#include <functional>

BOOST_AUTO_TEST_SUITE(taylor)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const OrientedMaterial oriented_material{"material", 0.};

  const Materials constants{
    {"material", EngineeringConstants::isotropic(1., 0.3)}};

  struct Shape
  {
    std::string  name;
    SectionShape shape;
  };

  const std::vector<Shape> shapes{
    {"rectangle", rectangle(3., 0.5, {0., 0.}, 2)},
    {"half disc", HalfDisc{0.7, 90., 0.0875, 8, oriented_material}},
    {"coarse half disc", HalfDisc{0.7, 75., 0.2, 4, oriented_material}},
    {"box",
     ThinWalled{ShapeKind::box,
                3.,
                4.,
                {0.3, 0.5},
                {0.2, 0.4},
                1,
                1,
                oriented_material}},
    {"double-T",
     ThinWalled{ShapeKind::double_t,
                3.,
                4.,
                {0.1},
                {0.2, 0.6},
                1,
                1,
                oriented_material}}};



  /// The half disc has many cells.
  unsigned int
  highest(const Shape &shape)
  {
    return shape.name == "half disc" ? 7 : 12;
  }



  TaylorElement
  element_of(const Shape &shape, const unsigned int degree)
  {
    return TaylorElement(make_section_mesh(shape.shape, constants), degree);
  }



  /// Calls use(cell, unit point, weight) for a Gauss rule of @p n points a
  /// direction on each cell; weights with the Jacobian.
  void
  for_each_point(
    const CrossSectionElement                                       &element,
    const unsigned int                                               n,
    const std::function<void(const FunctionValues &, const double)> &use)
  {
    const dealii::QGauss<2> rule(n);
    for (unsigned int cell = 0;
         cell < element.section_mesh().mesh.n_active_cells();
         ++cell)
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const FunctionValues f = element.evaluate(cell, rule.point(q));
          use(f, rule.weight(q) * determinant(f.jacobian));
        }
  }



  unsigned int
  n_polynomials(const unsigned int degree)
  {
    return (degree + 1) * (degree + 2) / 2;
  }



  /// The largest residual of the least squares fits of the columns of
  /// @p targets by those of @p basis, over the largest entry of each target.
  double
  worst_fit(const dealii::FullMatrix<double>          &basis,
            const std::vector<dealii::Vector<double>> &targets)
  {
    const dealii::Householder<double> qr(basis);
    double                            worst = 0.;
    for (const dealii::Vector<double> &target : targets)
      {
        dealii::Vector<double> x(basis.n()), residual(basis.m());
        qr.least_squares(x, target);
        basis.vmult(residual, x);
        residual -= target;
        worst = std::max(worst, residual.linfty_norm() / target.linfty_norm());
      }
    return worst;
  }
} // namespace

BOOST_AUTO_TEST_CASE(orthonormal)
{
  // Functions beyond the linear three are orthonormal among themselves and to
  // 1, x, z: 1/A int F_tau F_sigma dA. By a rule finer by four points a
  // direction, which on curved cells checks that the element's own is enough.
  for (const Shape &shape : shapes)
    for (const unsigned int degree : {3u, highest(shape)})
      {
        const TaylorElement element = element_of(shape, degree);
        const unsigned int  n       = element.n_functions();
        BOOST_TEST(n == n_polynomials(degree));
        dealii::FullMatrix<double> gram(n, n);
        double                     area = 0.;
        for_each_point(element,
                       element.n_gauss_points() + 4,
                       [&](const FunctionValues &f, const double weight) {
                         area += weight;
                         for (unsigned int i = 0; i < n; ++i)
                           for (unsigned int j = std::max(3u, i); j < n; ++j)
                             gram(i, j) += weight * f.values[i] * f.values[j];
                       });
        double worst = 0.;
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = std::max(3u, i); j < n; ++j)
            worst =
              std::max(worst, std::abs(gram(i, j) / area - (i == j ? 1. : 0.)));
        // Four sectors are half an arc to one side of a cell: what is left of
        // the rule's error on such cells is far below that of the geometry.
        BOOST_TEST(worst < (shape.name == "coarse half disc" ? 1e-7 : 1e-10),
                   shape.name << ", TE-" << degree << ": off by " << worst);
      }
}



BOOST_AUTO_TEST_CASE(spans_all_polynomials_and_no_others)
{
  // As many functions as polynomials, all of which they reproduce: no others.
  // x and z run from -1 to 1, so that the powers are of one size.
  for (const Shape &shape : shapes)
    for (const unsigned int degree : {2u, 5u, highest(shape)})
      {
        const TaylorElement element = element_of(shape, degree);
        const auto          box = element.bounding_box().get_boundary_points();
        std::vector<FunctionValues> points;
        for_each_point(element,
                       degree + 1,
                       [&](const FunctionValues &f, const double) {
                         points.push_back(f);
                       });
        dealii::FullMatrix<double> basis(points.size(), element.n_functions());
        for (unsigned int p = 0; p < points.size(); ++p)
          for (unsigned int tau = 0; tau < basis.n(); ++tau)
            basis(p, tau) = points[p].values[tau];
        const auto power = [&](const unsigned int i, const unsigned int j) {
          dealii::Vector<double> values(points.size());
          for (unsigned int p = 0; p < points.size(); ++p)
            {
              const Tensor<1, 2> x    = points[p].position - box.first,
                                 size = box.second - box.first;
              values[p]               = std::pow(2. * x[0] / size[0] - 1., i) *
                          std::pow(2. * x[1] / size[1] - 1., j);
            }
          return values;
        };
        std::vector<dealii::Vector<double>> powers;
        // Of degree 12 those of the highest degrees.
        for (unsigned int i = 0; i <= degree; ++i)
          for (unsigned int j = degree < 12 ? 0 : std::max(0, 11 - int(i));
               i + j <= degree;
               ++j)
            powers.push_back(power(i, j));
        BOOST_TEST(worst_fit(basis, powers) < 1e-9,
                   shape.name << ", TE-" << degree);
        // That the fit can fail: one degree more.
        if (degree < 6)
          BOOST_TEST(worst_fit(basis, {power(0, degree + 1)}) > 1e-6);
      }
}



BOOST_AUTO_TEST_CASE(derivatives)
{
  // Central differences along the cell's own coordinates and the chain rule,
  // d/dxi = J^T grad. What differences leave is d^2 / 6 of the third
  // derivative, on a rectangle at most that of Legendre's polynomial at its
  // end, with the norm 1: sqrt(2 N + 1) (N + 3)! / (48 (N - 3)!), 1393 for N =
  // 5 and 375375 for N = 12. Other sections may have ten times that.
  const double d = 1e-4;
  for (const Shape &shape : shapes)
    for (const auto &[degree, third] :
         {std::make_pair(5u, 1393.), std::make_pair(12u, 375375.)})
      {
        const TaylorElement element = element_of(shape, degree);
        double              worst   = 0.;
        for (unsigned int cell = 0;
             cell < element.section_mesh().mesh.n_active_cells();
             cell += 5)
          for (const Point<2> &unit : {Point<2>(0.3, 0.6), Point<2>(0.95, 0.1)})
            {
              const FunctionValues f = element.evaluate(cell, unit);
              for (unsigned int c = 0; c < 2; ++c)
                {
                  Point<2> before = unit, after = unit;
                  before[c] -= d;
                  after[c] += d;
                  const auto a = element.evaluate(cell, before),
                             b = element.evaluate(cell, after);
                  for (unsigned int tau = 0; tau < f.values.size(); ++tau)
                    {
                      double product = 0.;
                      for (unsigned int k = 0; k < 2; ++k)
                        product += f.gradients[tau][k] * f.jacobian[k][c];
                      const double difference =
                        (b.values[tau] - a.values[tau]) / (2. * d);
                      worst = std::max(worst, std::abs(difference - product));
                    }
                }
            }
        BOOST_TEST(worst < 10. * third * d * d / 6.,
                   shape.name << ", TE-" << degree << ": off by " << worst);
      }
}



BOOST_AUTO_TEST_CASE(points_of_sections_and_edges)
{
  // As many points as functions, which the values there fix; a grid whose areas
  // are positive and sum to that of the section.
  for (const Shape &shape : shapes)
    for (const unsigned int degree : {1u, 4u, highest(shape) - 3})
      {
        const TaylorElement element = element_of(shape, degree);
        const auto          points  = element.section_points();
        const unsigned int  n       = element.n_functions();
        BOOST_TEST(points.size() == n);
        dealii::FullMatrix<double> values(n, n);
        for (unsigned int i = 0; i < n; ++i)
          {
            const FunctionValues f =
              element.evaluate(points[i].cell, points[i].unit);
            BOOST_TEST(f.position.distance(points[i].position) < 1e-13);
            for (unsigned int tau = 0; tau < n; ++tau)
              values(i, tau) = f.values[tau];
          }
        // Of a value of one anywhere the functions are of the order of one.
        values.gauss_jordan();
        BOOST_TEST(values.linfty_norm() < 100.);

        double area = 0., sum = 0.;
        for_each_point(element,
                       element.n_gauss_points(),
                       [&](const FunctionValues &, const double weight) {
                         area += weight;
                       });
        for (const EdgePoint &p : element.section_grid())
          {
            BOOST_TEST(p.weight > 0.);
            sum += p.weight;
          }
        // Rules of 2, 5 and more points; the first misses curved cells.
        const bool curved = shape.name.find("disc") != std::string::npos;
        BOOST_TEST(std::abs(sum / area - 1.) < (!curved     ? 1e-12 :
                                                degree == 1 ? 0.1 :
                                                              1e-3));

        for (const auto &[id, boundary] : element.section_mesh().boundaries)
          {
            double length = 0., expected = 0.;
            for (const EdgePoint &p : element.edge_points(boundary))
              {
                length += p.weight;
                BOOST_TEST(std::abs(p.normal.norm() - 1.) < 1e-13);
              }
            for (const EdgePoint &p : edge_quadrature(element, boundary, 8))
              expected += p.weight;
            // Up to the Gauss rules of either on arcs.
            BOOST_TEST(std::abs(length / expected - 1.) <
                       (boundary == "arc" ? 1e-5 : 1e-12));
          }
      }
}



BOOST_AUTO_TEST_CASE(columns_span_the_nodal_space)
{
  // On a 3 x 2 grid the columns are forced. Fitted in points that are enough
  // for either, both ways.
  Laminate laminate      = rectangle(1.5, 0.4, {0., 0.});
  laminate.cells_across  = {1, 1, 1};
  laminate.across_breaks = {0.4, 1.1};
  for (const bool upright : {false, true})
    for (const unsigned int degree : {1, 2, 3})
      {
        if (upright)
          laminate.width = 0.15, laminate.across_breaks = {0.04, 0.11};
        const auto            mesh = make_section_mesh(laminate, constants);
        const LagrangeElement nodal(mesh, degree, 1e99),
          columns(mesh, degree, 1.);
        BOOST_TEST(nodal.n_functions() == (3 * degree + 1) * (2 * degree + 1));
        BOOST_TEST(columns.n_functions() == nodal.n_functions());
        std::set<unsigned int> of_nodal, of_columns;
        for (unsigned int tau = 0; tau < nodal.n_functions(); ++tau)
          {
            of_nodal.insert(nodal.level(tau));
            of_columns.insert(columns.level(tau));
            BOOST_TEST((columns.level(tau) == 0) == (tau < 3));
          }
        BOOST_TEST((of_nodal == std::set<unsigned int>{0, 1}));
        // With two nodes a column, LE-1 on one ply, nothing but columns would
        // be left; here there are three places at least.
        BOOST_TEST((of_columns == std::set<unsigned int>{0, 1, 2}));

        const auto values = [&](const LagrangeElement &element) {
          std::vector<std::vector<double>> rows;
          const dealii::QGauss<2>          rule(degree + 1);
          for (unsigned int cell = 0; cell < 6; ++cell)
            for (const Point<2> &unit : rule.get_points())
              {
                rows.emplace_back(element.n_functions(), 0.);
                const FunctionValues f       = element.evaluate(cell, unit);
                const auto          &numbers = element.cell_functions(cell);
                for (unsigned int k = 0; k < numbers.size(); ++k)
                  rows.back()[numbers[k]] = f.values[k];
              }
          dealii::FullMatrix<double> matrix(rows.size(), rows[0].size());
          for (unsigned int i = 0; i < rows.size(); ++i)
            for (unsigned int j = 0; j < rows[i].size(); ++j)
              matrix(i, j) = rows[i][j];
          return matrix;
        };
        const auto columns_of = [](const dealii::FullMatrix<double> &matrix) {
          std::vector<dealii::Vector<double>> all;
          for (unsigned int j = 0; j < matrix.n(); ++j)
            {
              all.emplace_back(matrix.m());
              for (unsigned int i = 0; i < matrix.m(); ++i)
                all.back()[i] = matrix(i, j);
            }
          return all;
        };
        const auto a = values(nodal), b = values(columns);
        BOOST_TEST(worst_fit(a, columns_of(b)) < 1e-10);
        BOOST_TEST(worst_fit(b, columns_of(a)) < 1e-10);
      }
}

BOOST_AUTO_TEST_SUITE_END()
