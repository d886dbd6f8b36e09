// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_point_compliance_h
#define lamella_solve_point_compliance_h

#include <deal.II/base/tensor.h>

#include <vector>

namespace lamella
{
  /// Normal and two tangential components (force or length) of all points.
  using PointVectors = std::vector<dealii::Tensor<1, 3>>;

  /// Returns the norm of the tangential components 1 and 2 of @p x.
  double
  tangential_norm(const dealii::Tensor<1, 3> &x);

  /// Returns @p x with its normal component 0 set to zero.
  dealii::Tensor<1, 3>
  tangential_part(dealii::Tensor<1, 3> x);

  /// Returns the scalar product of @p x and @p y, summed over all points.
  double
  inner_product(const PointVectors &x, const PointVectors &y);

  /// Returns the largest absolute value of all components of @p x.
  double
  largest_component(const PointVectors &x);

  /// Compliance matrix W of contact points: gaps and slips per unit force. A
  /// point has one matrix row for its normal and up to two for its tangents.
  struct PointCompliance
  {
    /// First matrix row of each point, then the number of matrix rows.
    std::vector<unsigned int> first{0};
    /// Matrix entries, column by column; the matrix is symmetric.
    std::vector<double> matrix;

    /// Returns the number of contact points.
    unsigned int
    n_points() const
    {
      return first.size() - 1;
    }
    /// Returns the number of matrix rows: one per point, and one per tangent.
    unsigned int
    n_rows() const
    {
      return first.back();
    }
    /// Returns the number of matrix rows of @p point: one plus its tangents.
    unsigned int
    size(const unsigned int point) const
    {
      return first[point + 1] - first[point];
    }
    /// Returns the entry in matrix row @p i and column @p j.
    double
    operator()(const unsigned int i, const unsigned int j) const
    {
      return matrix[std::size_t(j) * n_rows() + i];
    }
    /// @copydoc operator()(const unsigned int, const unsigned int) const
    double &
    operator()(const unsigned int i, const unsigned int j)
    {
      return matrix[std::size_t(j) * n_rows() + i];
    }

    /// Returns one vector per point from one entry per matrix row.
    PointVectors
    by_points(const std::vector<double> &rows) const;
    /// Returns the vectors @p points as one entry per matrix row.
    std::vector<double>
    by_rows(const PointVectors &points) const;

    /// Returns the gaps and slips W lambda due to the contact forces @p lambda.
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
