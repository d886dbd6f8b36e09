// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_dense_cholesky_h
#define lamella_linear_dense_cholesky_h

#include <vector>

namespace lamella
{
  /// The factor L of a dense symmetric positive definite matrix A = L L^T, by
  /// LAPACK. For the condensed systems of contact, C + d of the active rows:
  /// n^3/3 operations to factorise, 2 n^2 to solve, 8 n^2 bytes. Serial.
  class DenseCholesky
  {
  public:
    /// Takes the matrix as @p n columns one after the other; only its lower
    /// triangle is read. Throws NumericsError, saying that @p what is singular,
    /// if a pivot is not positive. The n x n numbers are moved in and
    /// overwritten by L; n may be zero.
    DenseCholesky(std::vector<double> matrix,
                  const unsigned int  n,
                  const char *const   what);

    /// x = A^-1 x. @p x has n numbers: the right-hand side, then the solution.
    void
    solve(std::vector<double> &x) const;

  private:
    /// L in the lower triangle, column by column; above it what stood there
    /// before.
    std::vector<double> factor;
    int                 n;
  };
} // namespace lamella

#endif
