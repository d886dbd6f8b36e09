// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_independent_rows_h
#define lamella_base_independent_rows_h

#include <deal.II/lac/lapack_full_matrix.h>

#include <vector>

namespace lamella
{
  /// Returns the numbers of independent rows of @p A by pivoted Cholesky
  /// factorization of A A^T (as LAPACK's dgeqp3 of A^T). Each is the row with
  /// the longest remainder orthogonal to the rows before. Ends if the remainder
  /// is below @p relative times the longest row: the chosen rows span all
  /// others.
  std::vector<unsigned int>
  select_independent_rows(const dealii::LAPACKFullMatrix<double> &A,
                          const double relative = 0.);
} // namespace lamella

#endif
