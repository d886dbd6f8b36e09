// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_independent_rows_h
#define lamella_base_independent_rows_h

#include <deal.II/lac/lapack_full_matrix.h>

#include <vector>

namespace lamella
{
  /// Returns the indices of a maximal set of linearly independent rows of @p A,
  /// by pivoted Cholesky factorization of A A^T (like LAPACK's dgeqp3 of A^T).
  /// Each step selects the row with the longest component orthogonal to the
  /// selected rows, until it is below @p relative times the longest row.
  std::vector<unsigned int>
  select_independent_rows(const dealii::LAPACKFullMatrix<double> &A,
                          const double relative = 0.);
} // namespace lamella

#endif
