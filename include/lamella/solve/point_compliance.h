// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_point_compliance_h
#define lamella_solve_point_compliance_h

#include <deal.II/base/tensor.h>

#include <vector>

namespace lamella
{
  /// Of each point of a contact what its normal row and its tangential rows
  /// have, (n, t_1, t_2): forces or lengths. Of tangents that a point has not,
  /// zero.
  using PointVectors = std::vector<dealii::Tensor<1, 3>>;

  /// The length of the tangential part of @p x.
  double
  tangential_norm(const dealii::Tensor<1, 3> &x);

  /// @p x without its normal part.
  dealii::Tensor<1, 3>
  tangential_part(dealii::Tensor<1, 3> x);

  /// x . y over all points.
  double
  inner_product(const PointVectors &x, const PointVectors &y);

  /// The largest component.
  double
  largest_component(const PointVectors &x);

  /**
   * The dense compliance W = B K^-1 B^T of points that may touch, whose rows
   * follow upon each other: of each the normal one, then its tangential ones,
   * none, one or two. Forces lambda move the points by W lambda.
   */
  struct PointCompliance
  {
    /// The first row of each point, and one past the last of all.
    std::vector<unsigned int> first{0};
    /// The entries of W, column by column; symmetric.
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
    /// One and the number of tangents of @p point.
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

    /// By points, and by rows again.
    PointVectors
    by_points(const std::vector<double> &rows) const;
    std::vector<double>
    by_rows(const PointVectors &points) const;

    /// W lambda.
    PointVectors
    times(const PointVectors &lambda) const;

    /// v += W_(.,i) change: what the force of @p point alone moves.
    void
    add_of_point(const unsigned int          point,
                 const dealii::Tensor<1, 3> &change,
                 PointVectors               &v) const;
  };
} // namespace lamella

#endif
