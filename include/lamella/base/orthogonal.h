// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_orthogonal_h
#define lamella_base_orthogonal_h

#include <vector>

namespace lamella
{
  /**
   * Makes @p v orthogonal to the vectors @p basis from number @p first on by
   * Gram-Schmidt,
   *   part_j = (v, b_j), v <- v - sum_j part_j b_j,
   * twice, which is sufficient to rounding. @p v is not normalized: the caller
   * decides whether the rest is rounding. Returns the sums of part_j, the
   * coefficients of the old v, from @p first on. T is a number or a tensor.
   * Costs 2 n m operations for m vectors of length n.
   * (dealii::QR::append_column makes one pass against all columns, in the
   * Euclidean product, and divides by the rest.)
   *
   * @param v changed in place
   * @param basis orthonormal from number first on; each as long as v
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
