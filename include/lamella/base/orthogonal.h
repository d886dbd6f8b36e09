// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_orthogonal_h
#define lamella_base_orthogonal_h

#include <vector>

namespace lamella
{
  /**
   * Gram and Schmidt, twice for the sake of rounding: takes out of @p v what
   * lies along the vectors @p basis from the number @p first on, which are
   * orthonormal in @p product, and returns how much along each. What is left is
   * not normalised: whether it is more than rounding decides the caller.
   *
   *   part_j = (v, b_j), v <- v - sum_j part_j b_j,
   *
   * done twice, after which v is orthogonal to rounding however nearly it
   * depended on the basis ("twice is enough"). T may be a number or a tensor;
   * @p product(v, b) is any inner product of two such vectors. Parts are
   * returned in the order of the basis from @p first on, the sum of both
   * passes, which are the coefficients of the old v in the basis. n m
   * operations for m vectors of the length n, twice. (dealii::QR::append_column
   * is one pass, against all columns, in the Euclidean product, and divides by
   * what is left.)
   *
   * @param v       is changed in place
   * @param basis   orthonormal from the number first on; as long as v each
   * @param product symmetric, positive definite, and bilinear
   */
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
