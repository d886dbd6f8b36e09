// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_dense_factors_h
#define lamella_linear_dense_factors_h

#include <vector>

namespace lamella
{
  /// The LU factorization P A = L U of a dense n x n matrix A with partial
  /// pivoting, by LAPACK. Takes 2 n^3 / 3 operations, and 2 n^2 for a solution.
  class DenseLU
  {
  public:
    /// Factorizes the n x n @p matrix, stored by columns; @p n may be zero.
    DenseLU(std::vector<double> matrix, const unsigned int n);

    /// Returns the ratio of the smallest to the largest |pivot|; 0 if singular.
    double
    pivot_ratio() const;

    /// Computes x = A^-1 x; @p x has n entries. A must not be singular.
    void
    solve(std::vector<double> &x) const;

    /// Returns the sign of det A: 1 or -1, 0 if singular.
    int
    sign_of_determinant() const;

  private:
    std::vector<double> factors;
    std::vector<int>    pivots;
    int                 n;
    bool                singular;
  };

  /// Returns x = A^-1 b for the n x n @p matrix A, stored by columns. If A is
  /// singular, x is the least-squares solution of A x = @p b that minimizes sum
  /// d_i x_i^2. Rows and columns are scaled by 1 / sqrt d_i, where @p d has the
  /// magnitudes d_i > 0 of the diagonal entries. A counts as singular if a
  /// pivot of the scaled matrix is below @p rounding times the largest pivot;
  /// singular values below @p rounding times the largest are then set to zero.
  std::vector<double>
  solve_dependent(const std::vector<double> &matrix,
                  const std::vector<double> &d,
                  const std::vector<double> &b,
                  const double               rounding);

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
