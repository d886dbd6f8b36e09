// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/linear/dense_factors.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/lapack_templates.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace lamella
{
  DenseLU::DenseLU(std::vector<double> matrix, const unsigned int n)
    : factors(std::move(matrix))
    , pivots(n)
    , n(n)
    , singular(false)
  {
    dealii::types::blas_int size = n, info = 0;
    if (n > 0)
      dealii::getrf(&size, &size, factors.data(), &size, pivots.data(), &info);
    singular = info != 0;
  }



  double
  DenseLU::pivot_ratio() const
  {
    if (singular || n == 0)
      return singular ? 0. : 1.;
    double least = std::abs(factors[0]), largest = least;
    for (int i = 1; i < n; ++i)
      {
        const double pivot = std::abs(factors[std::size_t(i) * n + i]);
        least              = std::min(least, pivot);
        largest            = std::max(largest, pivot);
      }
    return least / largest;
  }



  void
  DenseLU::solve(std::vector<double> &x) const
  {
    const dealii::types::blas_int size = n, one = 1;
    dealii::types::blas_int       info = 0;
    if (n > 0)
      dealii::getrs("N",
                    &size,
                    &one,
                    factors.data(),
                    &size,
                    pivots.data(),
                    x.data(),
                    &size,
                    &info);
  }



  int
  DenseLU::sign_of_determinant() const
  {
    if (singular)
      return 0;
    int sign = 1;
    for (int i = 0; i < n; ++i)
      {
        // LAPACK counts from 1: row i went to another place, or stayed.
        const bool was_swapped = pivots[i] != i + 1;
        const bool is_negative = factors[std::size_t(i) * n + i] < 0.;
        if (was_swapped != is_negative)
          sign = -sign;
      }
    return sign;
  }



  std::vector<double>
  solve_dependent(const std::vector<double> &matrix,
                  const std::vector<double> &d,
                  const std::vector<double> &b,
                  const double               rounding)
  {
    const std::size_t   n = b.size();
    std::vector<double> weight(n), weighted(matrix), x(b);
    for (std::size_t i = 0; i < n; ++i)
      weight[i] = 1. / std::sqrt(d[i]);
    for (std::size_t j = 0; j < n; ++j)
      {
        x[j] *= weight[j];
        for (std::size_t i = 0; i < n; ++i)
          weighted[j * n + i] *= weight[i] * weight[j];
      }
    const DenseLU factor(weighted, n);
    if (factor.pivot_ratio() >= rounding)
      factor.solve(x);
    else
      {
        dealii::LAPACKFullMatrix<double> inverse(n);
        std::copy(weighted.begin(), weighted.end(), &inverse(0, 0));
        inverse.compute_inverse_svd(rounding);
        const dealii::Vector<double> right(x.begin(), x.end());
        dealii::Vector<double>       found(n);
        inverse.vmult(found, right);
        std::copy(found.begin(), found.end(), x.begin());
      }
    for (std::size_t i = 0; i < n; ++i)
      x[i] *= weight[i];
    return x;
  }



  DenseCholesky::DenseCholesky(std::vector<double> matrix,
                               const unsigned int  n,
                               const char *const   what)
    : factor(std::move(matrix))
    , n(n)
  {
    dealii::types::blas_int size = n, info = 0;
    if (n > 0)
      dealii::potrf("L", &size, factor.data(), &size, &info);
    if (info != 0)
      throw NumericsError("linear.singular-matrix: " + std::string(what) +
                          " is numerically singular.");
  }



  void
  DenseCholesky::solve(std::vector<double> &x) const
  {
    const dealii::types::blas_int size = n, one = 1;
    dealii::types::blas_int       info = 0;
    if (n > 0)
      dealii::potrs(
        "L", &size, &one, factor.data(), &size, x.data(), &size, &info);
  }
} // namespace lamella
