// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_columns_h
#define lamella_linear_columns_h

#include <lamella/base/linear_algebra.h>

#include <deal.II/lac/lapack_full_matrix.h>

namespace lamella
{
  /// Returns the product of the sparse matrix @p A and the dense matrix @p X.
  /// Several columns of X are processed together, to read each entry of A once.
  /// Each column of the result is bitwise equal to a matrix-vector product.
  dealii::LAPACKFullMatrix<double>
  times_columns(const Matrix &A, const dealii::LAPACKFullMatrix<double> &X);
} // namespace lamella

#endif
