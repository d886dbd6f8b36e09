// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/point_compliance.h>

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
} // namespace lamella
