// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_independent_rows_h
#define lamella_base_independent_rows_h

#include <deal.II/lac/lapack_full_matrix.h>

#include <vector>

namespace lamella
{
  /// Returns the indices of a maximal set of linearly independent rows of @p A,
  /// by pivoted Cholesky factorization of A A^T (like LAPACK's dgeqp3 of A^T).
  /// Each step selects the row with the longest component orthogonal to the
  /// selected rows, until it is below @p relative times the longest row.
  std::vector<unsigned int>
  select_independent_rows(const dealii::LAPACKFullMatrix<double> &A,
                          const double relative = 0.);

  /// Makes @p v orthogonal to the vectors b_j of @p basis with j >= @p first by
  /// the Gram-Schmidt method, applied twice to reduce rounding errors,
  ///   c_j = (v, b_j), v <- v - sum_j c_j b_j.
  /// @p basis must be orthonormal in the inner product @p product. @p v is not
  /// normalized. Returns the coefficients c_j of the original v, from number @p
  /// first on. T is a number or a tensor.
  template <typename T, typename Product>
  std::vector<double>
  make_orthogonal(std::vector<T>                    &v,
                  const std::vector<std::vector<T>> &basis,
                  const Product                     &product,
                  const unsigned int                 first = 0)
  {
    std::vector<double> parts(basis.size() - first, 0.);
    for (unsigned int pass = 0; pass < 2; ++pass)
      for (unsigned int j = first; j < basis.size(); ++j)
        {
          const double part = product(v, basis[j]);
          parts[j - first] += part;
          for (unsigned int i = 0; i < v.size(); ++i)
            v[i] -= part * basis[j][i];
        }
    return parts;
  }
} // namespace lamella

#endif
