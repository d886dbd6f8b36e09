// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_dense_cholesky_h
#define lamella_linear_dense_cholesky_h

#include <vector>

namespace lamella
{
  /// The factor L of a dense symmetric positive definite matrix A = L L^T, by
  /// LAPACK.
  class DenseCholesky
  {
  public:
    /// Takes the matrix as @p n columns one after the other; only its lower
    /// triangle is read. Throws NumericsError, saying that @p what is singular,
    /// if a pivot is not positive.
    DenseCholesky(std::vector<double> matrix,
                  const unsigned int  n,
                  const char *const   what);

    /// x = A^-1 x.
    void
    solve(std::vector<double> &x) const;

  private:
    std::vector<double> factor;
    int                 n;
  };
} // namespace lamella

#endif
