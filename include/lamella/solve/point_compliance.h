// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_point_compliance_h
#define lamella_solve_point_compliance_h

#include <deal.II/base/tensor.h>

#include <vector>

namespace lamella
{
  /// Components (n, t_1, t_2) of forces or lengths at each contact point.
  using PointVectors = std::vector<dealii::Tensor<1, 3>>;

  /// Returns the length of the tangential part of @p x.
  double
  tangential_norm(const dealii::Tensor<1, 3> &x);

  /// Returns @p x without its normal part.
  dealii::Tensor<1, 3>
  tangential_part(dealii::Tensor<1, 3> x);

  /// Returns x . y, summed over all points.
  double
  inner_product(const PointVectors &x, const PointVectors &y);

  /// Returns the largest absolute component of all points.
  double
  largest_component(const PointVectors &x);

  /// The dense compliance W of contact points: gaps and slips per unit force
  /// [length / force]. Each point has consecutive rows, one for its normal and
  /// up to two for tangents.
  struct PointCompliance
  {
    /// First row of each point, and the total number of rows.
    std::vector<unsigned int> first{0};
    /// Entries of W, column by column; symmetric.
    std::vector<double> matrix;

    unsigned int
    n_points() const
    {
      return first.size() - 1;
    }
    unsigned int
    n_rows() const
    {
      return first.back();
    }
    /// Returns one plus the number of tangents of @p point.
    unsigned int
    size(const unsigned int point) const
    {
      return first[point + 1] - first[point];
    }
    double
    operator()(const unsigned int i, const unsigned int j) const
    {
      return matrix[std::size_t(j) * n_rows() + i];
    }
    double &
    operator()(const unsigned int i, const unsigned int j)
    {
      return matrix[std::size_t(j) * n_rows() + i];
    }

    /// Convert between a vector of rows of W and a vector of points.
    PointVectors
    by_points(const std::vector<double> &rows) const;
    std::vector<double>
    by_rows(const PointVectors &points) const;

    /// Returns W lambda, the gaps and slips due to the forces @p lambda.
    PointVectors
    times(const PointVectors &lambda) const;

    /// Adds the gaps and slips due to the force @p change at @p point to @p v.
    void
    add_of_point(const unsigned int          point,
                 const dealii::Tensor<1, 3> &change,
                 PointVectors               &v) const;
  };
} // namespace lamella

#endif
