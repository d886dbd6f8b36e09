// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/section/taylor_element.h>

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
    // What is left of a polynomial without its parts along the others must be
    // more than the rounding of those parts.
    constexpr double dependent = 1e-10;

    // On curved cells the polynomials of x and z are of three times the degree
    // in the cell's own coordinates, but nearly of the same: these points more
    // leave little (tests/unit/taylor.cc).
    constexpr unsigned int points_for_curves = 8;
  } // namespace



  TaylorElement::TaylorElement(std::shared_ptr<const SectionMesh> mesh_,
                               const unsigned int                 degree)
    : CrossSectionElement(mesh_)
    , order(degree)
    , gauss_points(degree + 1 +
                   (has_curved_edges(*mesh_) ? points_for_curves : 0))
    , geometry(mesh_, has_curved_edges(*mesh_) ? 3 : 1)
  {
    const auto box = bounding_box().get_boundary_points();
    middle         = box.first + 0.5 * (box.second - box.first);
    half           = 0.5 * (box.second - box.first);
    orthonormalise();
    functions.resize(recurrence.size());
    std::iota(functions.begin(), functions.end(), 0);
  }



  Point<2>
  TaylorElement::scaled(const Point<2> &position) const
  {
    return {(position[0] - middle[0]) / half[0],
            (position[1] - middle[1]) / half[1]};
  }



  double
  TaylorElement::area() const
  {
    const QGauss<2> quadrature(gauss_points);
    double          sum = 0.;
    for (unsigned int cell = 0; cell < geometry.n_cells(); ++cell)
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        sum += quadrature.weight(q) *
               determinant(geometry.map(cell, quadrature.point(q)).jacobian);
    return sum;
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
    const double sum = area();
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
    step.parts.assign(values.size(), 0.);
    const double before = std::sqrt(product(fresh, fresh));
    for (unsigned int pass = 0; pass < 2; ++pass)
      for (unsigned int j = 0; j < values.size(); ++j)
        {
          const double part = product(fresh, values[j]);
          step.parts[j] += part;
          for (unsigned int q = 0; q < n; ++q)
            fresh[q] -= part * values[j][q];
        }
    step.norm = std::sqrt(product(fresh, fresh));
    if (!(step.norm > dependent * before))
      return;
    for (double &value : fresh)
      value /= step.norm;
    recurrence.push_back(std::move(step));
    values.push_back(std::move(fresh));
  }



  void
  TaylorElement::orthonormalise()
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
        for (unsigned int j = 0; j < k; ++j)
          {
            value -= step.parts[j] * values[j];
            gradient -= step.parts[j] * gradients[j];
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
    const QGaussLobatto<1> along(order + 1);
    // Two sides share the point between them; others have no vertex.
    std::vector<EdgePoint>               points;
    std::map<unsigned int, unsigned int> at_vertex;
    for (const auto &[c, f] : boundary_faces(boundary))
      for (unsigned int q = 0; q < along.size(); ++q)
        {
          const auto cell = std::next(mesh->mesh.begin_active(), c);
          EdgePoint  point;
          point.cell               = c;
          point.unit               = face_point(f, along.point(q)[0]);
          const auto [position, J] = geometry.map(c, point.unit);
          const Tensor<1, 2> n     = along.weight(q) * scaled_face_normal(f, J);
          unsigned int       number = points.size();
          if (q == 0 || q + 1 == along.size())
            number = at_vertex
                       .emplace(cell->face(f)->vertex_index(q == 0 ? 0 : 1),
                                points.size())
                       .first->second;
          if (number == points.size())
            {
              point.position = position;
              point.depth    = depth(c, f);
              points.push_back(point);
            }
          points[number].normal += n;
          points[number].weight += n.norm();
        }
    for (EdgePoint &point : points)
      point.normal /= point.normal.norm();
    return points;
  }



  namespace
  {
    /// The numbers of as many of @p rows, one a candidate, as they have
    /// entries, chosen one by one: the longest of what is left of them.
    std::vector<unsigned int>
    most_independent(std::vector<Vector<double>> rows)
    {
      const unsigned int        n = rows[0].size();
      std::vector<unsigned int> chosen;
      while (chosen.size() < n)
        {
          const auto longest =
            std::max_element(rows.begin(),
                             rows.end(),
                             [](const auto &a, const auto &b) {
                               // Equal up to rounding: the first, always.
                               return a.norm_sqr() < (1. - 1e-9) * b.norm_sqr();
                             });
          chosen.push_back(longest - rows.begin());
          const Vector<double> direction = *longest;
          const double         square    = direction.norm_sqr();
          for (Vector<double> &row : rows)
            row.add(-(row * direction) / square, direction);
        }
      return chosen;
    }
  } // namespace



  std::vector<EdgePoint>
  TaylorElement::section_points() const
  {
    // The ends of a side, at least.
    const QGaussLobatto<2>      candidates_of_cell(order + 1);
    std::vector<EdgePoint>      candidates;
    std::vector<Vector<double>> rows;
    std::vector<double>         values;
    std::vector<Tensor<1, 2>>   gradients;
    for (unsigned int cell = 0; cell < geometry.n_cells(); ++cell)
      for (const Point<2> &unit : candidates_of_cell.get_points())
        {
          EdgePoint point;
          point.cell     = cell;
          point.unit     = unit;
          point.position = geometry.map(cell, unit).position;
          candidates.push_back(point);
          evaluate_polynomials(point.position, values, gradients);
          rows.emplace_back(values.begin(), values.end());
        }

    const std::vector<unsigned int> chosen = most_independent(rows);
    const unsigned int              n      = chosen.size();
    // sum_i w_i F_tau(x_i) = int F_tau dA, which is A for the first, or none.
    LAPACKFullMatrix<double> system(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int tau = 0; tau < n; ++tau)
        system(tau, i) = rows[chosen[i]][tau];
    Vector<double> weights(n);
    weights[0] = area();
    system.compute_lu_factorization();
    system.solve(weights);
    std::vector<EdgePoint> points;
    for (unsigned int i = 0; i < n; ++i)
      {
        points.push_back(candidates[chosen[i]]);
        points.back().weight = weights[i];
      }
    return points;
  }
} // namespace lamella
