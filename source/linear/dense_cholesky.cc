// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/linear/dense_cholesky.h>

#include <deal.II/lac/lapack_templates.h>

#include <string>

namespace lamella
{
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
