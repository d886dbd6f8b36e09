// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/interface_system.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  double
  tangential_norm(const Tensor<1, 3> &x)
  {
    return std::hypot(x[1], x[2]);
  }



  Tensor<1, 3>
  tangential_part(Tensor<1, 3> x)
  {
    x[0] = 0.;
    return x;
  }



  double
  inner_product(const PointVectors &x, const PointVectors &y)
  {
    double sum = 0.;
    for (unsigned int i = 0; i < x.size(); ++i)
      sum += x[i] * y[i];
    return sum;
  }



  double
  largest_component(const PointVectors &x)
  {
    double result = 0.;
    for (const Tensor<1, 3> &point : x)
      for (unsigned int c = 0; c < 3; ++c)
        result = std::max(result, std::abs(point[c]));
    return result;
  }



  PointVectors
  PointCompliance::by_points(const std::vector<double> &rows) const
  {
    PointVectors points(n_points());
    for (unsigned int i = 0; i < n_points(); ++i)
      for (unsigned int c = 0; c < size(i); ++c)
        points[i][c] = rows[first[i] + c];
    return points;
  }



  std::vector<double>
  PointCompliance::by_rows(const PointVectors &points) const
  {
    std::vector<double> rows;
    rows.reserve(n_rows());
    for (unsigned int i = 0; i < n_points(); ++i)
      for (unsigned int c = 0; c < size(i); ++c)
        rows.push_back(points[i][c]);
    return rows;
  }



  PointVectors
  PointCompliance::times(const PointVectors &lambda) const
  {
    PointVectors v(n_points());
    for (unsigned int i = 0; i < n_points(); ++i)
      if (lambda[i] != Tensor<1, 3>())
        add_of_point(i, lambda[i], v);
    return v;
  }



  void
  PointCompliance::add_of_point(const unsigned int  point,
                                const Tensor<1, 3> &change,
                                PointVectors       &v) const
  {
    for (unsigned int c = 0; c < size(point); ++c)
      {
        const double *entry =
          matrix.data() + std::size_t(first[point] + c) * n_rows();
        for (unsigned int i = 0; i < n_points(); ++i)
          for (unsigned int d = 0; d < size(i); ++d)
            v[i][d] += *entry++ * change[c];
      }
  }



  Compliance::Compliance(const TangentOperator &tangent_operator,
                         const GapConstraints  &rows)
    : tangent_operator(tangent_operator)
    , rows(rows)
    , place(3 * rows.size(), dealii::numbers::invalid_unsigned_int)
  {
    for (unsigned int b = 0; b < tangent_operator.of().bodies().size(); ++b)
      bodies.push_back({tangent_operator.solver(b).solved_rows(), {}});
  }



  void
  Compliance::include(const std::vector<unsigned int> &wanted)
  {
    std::vector<unsigned int> fresh;
    for (const unsigned int r : wanted)
      if (!is_included(r))
        {
          place[r] = entries.size();
          entries.emplace_back(entries.size() + 1, 0.);
          fresh.push_back(r);
        }
    if (fresh.empty())
      return;
    included.push_back(fresh);

    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const unsigned int            first = bodies[b].solved->size();
        std::vector<LinearFunctional> reduced;
        for (const unsigned int r : fresh)
          for (const BodyFunctional &part : rows.constraint(r).parts)
            if (part.body == b)
              {
                reduced.push_back(part.row.reduced(
                  tangent_operator.reduction(b).constraints()));
                bodies[b].place.push_back(place[r]);
              }
        bodies[b].solved->append(reduced);

        const std::vector<double> products  = bodies[b].solved->products(first);
        const std::vector<unsigned int> &at = bodies[b].place;
        const std::size_t                n  = at.size() - first;
        for (unsigned int j = 0; j < at.size(); ++j)
          for (unsigned int i = first; i < at.size(); ++i)
            if (at[j] <= at[i])
              entries[at[i]][at[j]] += products[j * n + i - first];
      }
  }



  double
  Compliance::diagonal(const unsigned int row) const
  {
    return entries[place[row]].back();
  }



  std::vector<double>
  Compliance::among(const std::vector<unsigned int> &of) const
  {
    const std::size_t   n = of.size();
    std::vector<double> matrix(n * n);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = j; i < n; ++i)
        {
          const unsigned int p = place[of[i]], q = place[of[j]];
          const double       entry = entries[std::max(p, q)][std::min(p, q)];
          matrix[j * n + i] = matrix[i * n + j] = entry;
        }
    return matrix;
  }



  BlockVector
  Compliance::displacement(const std::vector<unsigned int> &of,
                           const std::vector<double>       &lambda) const
  {
    BlockVector         u = tangent_operator.of().zero();
    std::vector<double> force(entries.size(), 0.);
    for (unsigned int i = 0; i < of.size(); ++i)
      force[place[of[i]]] = lambda[i];
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        std::vector<double> of_body;
        for (const unsigned int p : bodies[b].place)
          of_body.push_back(force[p]);
        u.block(b) = bodies[b].solved->displacement(of_body);
        tangent_operator.reduction(b).constraints().distribute(u.block(b));
      }
    return u;
  }
} // namespace lamella
