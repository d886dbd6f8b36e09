// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/linear/factor_row.h>

#include <algorithm>
#include <array>
#include <vector>

namespace lamella
{
  dealii::LAPACKFullMatrix<double>
  times_columns(const Matrix &A, const dealii::LAPACKFullMatrix<double> &X)
  {
    AssertDimension(A.n(), X.m());
    // As many as the sums of a row have registers for.
    constexpr unsigned int                 width = 16;
    dealii::LAPACKFullMatrix<double>       result(A.m(), X.n());
    std::vector<std::array<double, width>> beside(X.m());
    for (unsigned int first = 0; first < X.n(); first += width)
      {
        const unsigned int count = std::min<unsigned int>(width, X.n() - first);
        for (unsigned int c = 0; c < width; ++c)
          for (unsigned int i = 0; i < X.m(); ++i)
            beside[i][c] = c < count ? X(i, first + c) : 0.;
        for (unsigned int row = 0; row < A.m(); ++row)
          {
            std::array<double, width> sum{};
            for (auto entry = A.begin(row); entry != A.end(row); ++entry)
              {
                const double                     a = entry->value();
                const std::array<double, width> &x = beside[entry->column()];
                for (unsigned int c = 0; c < width; ++c)
                  sum[c] += a * x[c];
              }
            for (unsigned int c = 0; c < count; ++c)
              result(row, first + c) = sum[c];
          }
      }
    return result;
  }
} // namespace lamella
