// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_dense_cholesky_h
#define lamella_linear_dense_cholesky_h

#include <vector>

namespace lamella
{
  /// The factor L of a dense symmetric positive definite matrix A = L L^T, by
  /// LAPACK. n^3/3 operations to factorize, 2 n^2 to solve. Serial.
  class DenseCholesky
  {
  public:
    /// Factorizes the matrix given as @p n consecutive columns, of which only
    /// the lower triangle is read; n may be zero. Throws NumericsError, naming
    /// @p what, if a pivot is not positive.
    DenseCholesky(std::vector<double> matrix,
                  const unsigned int  n,
                  const char *const   what);

    /// Computes x = A^-1 x; @p x has n entries.
    void
    solve(std::vector<double> &x) const;

  private:
    /// L in the lower triangle, by columns; original entries above.
    std::vector<double> factor;
    int                 n;
  };
} // namespace lamella

#endif
