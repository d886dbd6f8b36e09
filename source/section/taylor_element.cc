// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/base/linear_functional.h>
#include <lamella/section/taylor_element.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <map>
#include <numeric>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Smallest rest of an orthogonalized polynomial, above its rounding.
    constexpr double dependent = arithmetic::rounding_of_solutions;

    // On curved cells the polynomials of x and z are of three times the degree
    // in the cell's own coordinates, but nearly of the same: these points more
    // leave little (tests/unit/taylor.cc).
    constexpr unsigned int points_for_curves = 8;
  } // namespace



  TaylorElement::TaylorElement(const std::shared_ptr<const SectionMesh> &mesh_,
                               const unsigned int                        degree)
    : CrossSectionElement(mesh_, has_curved_edges(*mesh_) ? 3 : 1)
    , order(degree)
    , gauss_points(degree + 1 +
                   (has_curved_edges(*mesh_) ? points_for_curves : 0))
  {
    const auto box = bounding_box().get_boundary_points();
    middle         = box.first + 0.5 * (box.second - box.first);
    half           = 0.5 * (box.second - box.first);
    orthonormalize();
    functions.resize(recurrence.size());
    std::iota(functions.begin(), functions.end(), 0);
  }



  unsigned int
  TaylorElement::trace_degree() const
  {
    const unsigned int geometric = geometry.fe().degree;
    return std::min(geometric * order, order + points_for_curves);
  }



  Point<2>
  TaylorElement::scaled(const Point<2> &position) const
  {
    return {(position[0] - middle[0]) / half[0],
            (position[1] - middle[1]) / half[1]};
  }



  void
  TaylorElement::collect_points(std::vector<Point<2>> &points,
                                std::vector<double>   &weights) const
  {
    const QGauss<2> quadrature(gauss_points);
    for (unsigned int cell = 0; cell < geometry.n_cells(); ++cell)
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const auto [position, jacobian] =
            geometry.map(cell, quadrature.point(q));
          points.push_back(position);
          weights.push_back(quadrature.weight(q) * determinant(jacobian));
        }
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.);
    for (double &weight : weights)
      weight /= sum;
  }



  void
  TaylorElement::add_polynomial(const unsigned int                parent,
                                const unsigned int                direction,
                                const std::vector<Point<2>>      &points,
                                const std::vector<double>        &weights,
                                std::vector<std::vector<double>> &values)
  {
    const unsigned int  n = points.size();
    std::vector<double> fresh(n);
    const auto          product = [&](const std::vector<double> &a,
                             const std::vector<double> &b) {
      double sum = 0.;
      for (unsigned int q = 0; q < n; ++q)
        sum += weights[q] * a[q] * b[q];
      return sum;
    };
    for (unsigned int q = 0; q < n; ++q)
      fresh[q] = scaled(points[q])[direction] * values[parent][q];

    Step step;
    step.parent    = parent;
    step.direction = direction;
    step.degree    = recurrence[parent].degree + 1;
    while (recurrence[step.first].degree + 2 < step.degree)
      ++step.first;
    const double before = std::sqrt(product(fresh, fresh));
    step.parts          = make_orthogonal(fresh, values, product, step.first);
    step.norm           = std::sqrt(product(fresh, fresh));
    if (!(step.norm > dependent * before))
      return;
    for (double &value : fresh)
      value /= step.norm;
    recurrence.push_back(std::move(step));
    values.push_back(std::move(fresh));
  }



  void
  TaylorElement::orthonormalize()
  {
    std::vector<Point<2>> points;
    std::vector<double>   weights;
    collect_points(points, weights);

    recurrence.emplace_back();
    std::vector<std::vector<double>> values{
      std::vector<double>(points.size(), 1.)};
    for (unsigned int degree = 1; degree <= order; ++degree)
      {
        // x times those of one degree less, and z times the last of them.
        const unsigned int known = recurrence.size();
        unsigned int       last  = 0;
        for (unsigned int parent = 0; parent < known; ++parent)
          if (recurrence[parent].degree + 1 == degree)
            {
              add_polynomial(parent, 0, points, weights, values);
              last = parent;
            }
        add_polynomial(last, 1, points, weights, values);
      }
  }



  void
  TaylorElement::evaluate_polynomials(
    const Point<2>            &position,
    std::vector<double>       &values,
    std::vector<Tensor<1, 2>> &gradients) const
  {
    const Point<2> x = scaled(position);
    values           = {1.};
    gradients        = {Tensor<1, 2>()};
    for (unsigned int k = 1; k < recurrence.size(); ++k)
      {
        const Step  &step     = recurrence[k];
        const double t        = x[step.direction];
        double       value    = t * values[step.parent];
        Tensor<1, 2> gradient = t * gradients[step.parent];
        gradient[step.direction] += values[step.parent] / half[step.direction];
        for (unsigned int j = step.first; j < k; ++j)
          {
            const double part = step.parts[j - step.first];
            value -= part * values[j];
            gradient -= part * gradients[j];
          }
        values.push_back(value / step.norm);
        gradients.push_back(gradient / step.norm);
      }
  }



  FunctionValues
  TaylorElement::evaluate(const unsigned int cell, const Point<2> &unit) const
  {
    const auto [position, jacobian]  = geometry.map(cell, unit);
    FunctionValues            result = linear_functions(position, jacobian);
    std::vector<double>       values;
    std::vector<Tensor<1, 2>> gradients;
    if (order > 1)
      {
        evaluate_polynomials(position, values, gradients);
        result.values.insert(result.values.end(),
                             values.begin() + 3,
                             values.end());
        result.gradients.insert(result.gradients.end(),
                                gradients.begin() + 3,
                                gradients.end());
      }
    return result;
  }



  std::vector<EdgePoint>
  TaylorElement::edge_points(const std::string &boundary) const
  {
    const GaussLobattoBasis &basis = GaussLobattoBasis::of_degree(order);
    std::vector<double>      shares(basis.size());
    const QGauss<1>          quadrature(order + 3);
    // Two sides share the point between them; others have no vertex.
    std::vector<EdgePoint>               points;
    std::map<unsigned int, unsigned int> at_vertex;
    // By number: to walk to each of many cells takes as many steps.
    std::vector<Triangulation<2>::active_cell_iterator> cells;
    for (const auto &cell : mesh->mesh.active_cell_iterators())
      cells.push_back(cell);
    for (const auto &[c, f] : boundary_faces(boundary))
      for (unsigned int i = 0; i < basis.size(); ++i)
        {
          const auto  &cell   = cells[c];
          unsigned int number = points.size();
          if (i == 0 || i + 1 == basis.size())
            number = at_vertex
                       .emplace(cell->face(f)->vertex_index(i == 0 ? 0 : 1),
                                points.size())
                       .first->second;
          const Point<2> unit = face_point(f, basis.point(i));
          if (number == points.size())
            {
              points.push_back(point_at(c, unit));
              points.back().depth = depth(c, f);
            }
          const auto value = [&](const double t) {
            basis.evaluate(t, shares.data(), nullptr);
            return shares[i];
          };
          add_side(points[number],
                   side_share(c, f, quadrature, value),
                   scaled_face_normal(f, geometry.map(c, unit).jacobian));
        }
    for (EdgePoint &point : points)
      point.normal /= point.normal.norm();
    return points;
  }



  std::vector<EdgePoint>
  TaylorElement::section_grid() const
  {
    // Cells share points on their sides: the same place to rounding.
    const QGaussLobatto<2>                     rule(order + 1);
    std::map<std::pair<long, long>, EdgePoint> found;
    const auto                                 key = [this](const Point<2> &x) {
      return std::make_pair(std::lround(1e8 * (x[0] - middle[0]) / length),
                            std::lround(1e8 * (x[1] - middle[1]) / length));
    };
    for (unsigned int cell = 0; cell < geometry.n_cells(); ++cell)
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const auto [position, J] = geometry.map(cell, rule.point(q));
          EdgePoint &point         = found[key(position)];
          if (point.weight == 0.)
            point = point_at(cell, rule.point(q));
          point.weight += rule.weight(q) * determinant(J);
        }
    std::vector<EdgePoint> points;
    for (const auto &[place, point] : found)
      points.push_back(point);
    return points;
  }



  std::vector<EdgePoint>
  TaylorElement::section_points() const
  {
    // The ends of a side, at least.
    const QGaussLobatto<2>    candidates_of_cell(order + 1);
    std::vector<EdgePoint>    candidates;
    std::vector<double>       values;
    std::vector<Tensor<1, 2>> gradients;
    LAPACKFullMatrix<double>  rows(geometry.n_cells() *
                                    candidates_of_cell.size(),
                                  recurrence.size());
    for (unsigned int cell = 0; cell < geometry.n_cells(); ++cell)
      for (const Point<2> &unit : candidates_of_cell.get_points())
        {
          candidates.push_back(point_at(cell, unit));
          evaluate_polynomials(candidates.back().position, values, gradients);
          for (unsigned int c = 0; c < values.size(); ++c)
            rows(candidates.size() - 1, c) = values[c];
        }

    std::vector<EdgePoint> points;
    for (const unsigned int i : select_independent_rows(rows))
      points.push_back(candidates[i]);
    return points;
  }
} // namespace lamella
