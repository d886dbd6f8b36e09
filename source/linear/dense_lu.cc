// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/linear/dense_lu.h>

#include <deal.II/lac/lapack_templates.h>

namespace lamella
{
  DenseLU::DenseLU(std::vector<double> matrix, const unsigned int n)
    : factors(std::move(matrix))
    , pivots(n)
    , n(n)
    , singular(false)
  {
    dealii::types::blas_int size = n, info = 0;
    if (n > 0)
      dealii::getrf(&size, &size, factors.data(), &size, pivots.data(), &info);
    singular = info != 0;
  }



  void
  DenseLU::solve(std::vector<double> &x) const
  {
    const dealii::types::blas_int size = n, one = 1;
    dealii::types::blas_int       info = 0;
    if (n > 0)
      dealii::getrs("N",
                    &size,
                    &one,
                    factors.data(),
                    &size,
                    pivots.data(),
                    x.data(),
                    &size,
                    &info);
  }



  int
  DenseLU::sign_of_determinant() const
  {
    if (singular)
      return 0;
    int sign = 1;
    for (int i = 0; i < n; ++i)
      {
        // LAPACK counts from 1: row i went to another place, or stayed.
        const bool was_swapped = pivots[i] != i + 1;
        const bool is_negative = factors[std::size_t(i) * n + i] < 0.;
        if (was_swapped != is_negative)
          sign = -sign;
      }
    return sign;
  }
} // namespace lamella
