// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_independent_rows_h
#define lamella_base_independent_rows_h

#include <deal.II/lac/lapack_full_matrix.h>

#include <vector>

namespace lamella
{
  /**
   * The numbers of rows of @p A, one a candidate, at most as many as it has
   * columns, chosen one by one: the longest of what is left of them without
   * their parts along those before (pivoted Cholesky factorisation of A A^T, or
   * LAPACK's dgeqp3 of A^T, but that chooses among equals by rounding). It ends
   * where what is left is below @p relative times the longest row at the
   * start: the rows chosen then span all others.
   */
  std::vector<unsigned int>
  most_independent(const dealii::LAPACKFullMatrix<double> &A,
                   const double                            relative = 0.);
} // namespace lamella

#endif
