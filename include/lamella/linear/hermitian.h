// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_hermitian_h
#define lamella_linear_hermitian_h

#include <lamella/base/linear_algebra.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * Solves (P + i Q) (x + i y) = f for each real right-hand side f. P + i Q is
   * Hermitian and positive definite: P = @p real symmetric, Q = @p imaginary
   * antisymmetric, with the same sparsity pattern; the upper triangles are
   * read. CHOLMOD factorizes the complex matrix.
   *
   * Returns x of the first right-hand side, y of it, x of the second, and so
   * on. Throws NumericsError, naming the matrix @p what, if a pivot is not
   * positive. Serial.
   */
  std::vector<Vector>
  solve_hermitian(const Matrix              &real,
                  const Matrix              &imaginary,
                  const std::vector<Vector> &right_hand_sides,
                  const std::string         &what);
} // namespace lamella

#endif
