// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_dense_lu_h
#define lamella_linear_dense_lu_h

#include <vector>

namespace lamella
{
  /// The factors P A = L U of a dense matrix, with partial pivoting, by LAPACK:
  /// for the condensed systems of contact with friction, which are not
  /// symmetric. 2 n^3 / 3 operations to factorise, 2 n^2 to solve, 8 n^2 bytes.
  /// Serial.
  class DenseLU
  {
  public:
    /// Takes the matrix as @p n columns one after the other. Singular where a
    /// pivot is zero. The n x n numbers are moved in and overwritten; n may be
    /// zero.
    DenseLU(std::vector<double> matrix, const unsigned int n);

    bool
    is_singular() const
    {
      return singular;
    }

    /// The smallest over the largest pivot; 0 of a singular matrix.
    double
    pivot_ratio() const;

    /// x = A^-1 x. @p x has n numbers: the right-hand side, then the solution.
    /// A must not be singular.
    void
    solve(std::vector<double> &x) const;

    /// The sign of det A: 1 or -1, 0 of a singular matrix.
    int
    sign_of_determinant() const;

  private:
    std::vector<double> factors;
    std::vector<int>    pivots;
    int                 n;
    bool                singular;
  };

  /// x = A^-1 b; where rows depend on each other, the x of least norm, sum d_i
  /// x_i^2, among those for which A x comes nearest to @p b, each row weighted
  /// with 1 / sqrt d_i, the size d_i > 0 of its diagonal. @p matrix are n
  /// columns one after the other. Rows depend on each other if a pivot of the
  /// weighted matrix is below @p rounding of the largest; its singular values
  /// below that share count as zero then (LAPACK's gesdd, some 20 n^3
  /// operations).
  std::vector<double>
  solve_dependent(const std::vector<double> &matrix,
                  const std::vector<double> &d,
                  const std::vector<double> &b,
                  const double               rounding);
} // namespace lamella

#endif
