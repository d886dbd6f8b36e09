// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_dense_cholesky_h
#define lamella_linear_dense_cholesky_h

#include <vector>

namespace lamella
{
  /// The Cholesky factor L of a dense symmetric positive definite n x n matrix
  /// A = L L^T, by LAPACK. Takes n^3/3 operations, and 2 n^2 for a solution.
  class DenseCholesky
  {
  public:
    /// Factorizes the n x n @p matrix, stored by columns, of which only the
    /// lower triangle is read; @p n may be zero. Throws NumericsError, with
    /// @p what as name of the matrix, if a pivot is not positive.
    DenseCholesky(std::vector<double> matrix,
                  const unsigned int  n,
                  const char *const   what);

    /// Computes x = A^-1 x; @p x has n entries.
    void
    solve(std::vector<double> &x) const;

  private:
    /// Columns of L in the lower triangle, unchanged entries of A above.
    std::vector<double> factor;
    int                 n;
  };
} // namespace lamella

#endif
