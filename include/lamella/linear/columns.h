// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_columns_h
#define lamella_linear_columns_h

#include <lamella/base/linear_algebra.h>

#include <deal.II/lac/lapack_full_matrix.h>

namespace lamella
{
  /// Returns A X for a sparse matrix A and many columns X. Several columns are
  /// processed together, so that an entry of A is read once for all of them.
  /// Sums have the order of a product with one vector.
  dealii::LAPACKFullMatrix<double>
  times_columns(const Matrix &A, const dealii::LAPACKFullMatrix<double> &X);
} // namespace lamella

#endif
