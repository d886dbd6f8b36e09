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
