// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_hermitian_h
#define lamella_linear_hermitian_h

#include <lamella/base/linear_algebra.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Solves (P + i Q) (x + i y) = f for each real right-hand side f with
  /// CHOLMOD's complex Cholesky factorization. P + i Q must be Hermitian and
  /// positive definite: P = @p real is symmetric, Q = @p imaginary
  /// antisymmetric. Only their upper triangles, of the same pattern, are read.
  ///
  /// Returns x and y of the first right-hand side, then of the second, and so
  /// on. Throws NumericsError, with @p what as name of the matrix, if a pivot
  /// is not positive. Serial.
  std::vector<Vector>
  solve_hermitian(const Matrix              &real,
                  const Matrix              &imaginary,
                  const std::vector<Vector> &right_hand_sides,
                  const std::string         &what);
} // namespace lamella

#endif
