// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_dense_lu_h
#define lamella_linear_dense_lu_h

#include <vector>

namespace lamella
{
  /// The factors P A = L U of a dense matrix with partial pivoting, by LAPACK.
  /// 2 n^3 / 3 operations to factorize, 2 n^2 to solve. Serial.
  class DenseLU
  {
  public:
    /// Factorizes the matrix given as @p n consecutive columns; n may be zero.
    /// It is singular if a pivot is zero.
    DenseLU(std::vector<double> matrix, const unsigned int n);

    bool
    is_singular() const
    {
      return singular;
    }

    /// Returns the smallest over the largest pivot; 0 if singular.
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

  /// Returns x = A^-1 b, if A is singular the x of least norm sum d_i x_i^2
  /// among the minimizers of A x - @p b. Row i is weighted with 1 / sqrt d_i,
  /// where d_i > 0 is the size of its diagonal. @p matrix has n consecutive
  /// columns. A is singular if a pivot of the weighted matrix is below
  /// @p rounding times the largest; smaller singular values are then zero
  /// (LAPACK's gesdd).
  std::vector<double>
  solve_dependent(const std::vector<double> &matrix,
                  const std::vector<double> &d,
                  const std::vector<double> &b,
                  const double               rounding);
} // namespace lamella

#endif
