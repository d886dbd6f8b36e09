// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/linear_functional.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Of those that are equal up to rounding the first, always.
    std::vector<double>::iterator
    first_of_largest(std::vector<double> &values)
    {
      return std::max_element(values.begin(),
                              values.end(),
                              [](const double a, const double b) {
                                return a < (1. - arithmetic::negligible) * b;
                              });
    }



    /// Row @p row of @p A less its parts along @p directions, unit vectors.
    Vector
    rest_of_row(const LAPACKFullMatrix<double> &A,
                const unsigned int              row,
                const std::vector<Vector>      &directions)
    {
      Vector rest(A.n());
      for (unsigned int c = 0; c < A.n(); ++c)
        rest[c] = A(row, c);
      for (unsigned int pass = 0; pass < 2; ++pass)
        for (const Vector &known : directions)
          rest.add(-(rest * known), known);
      return rest;
    }
  } // namespace



  std::vector<unsigned int>
  select_independent_rows(const LAPACKFullMatrix<double> &A,
                          const double                    relative)
  {
    std::vector<double> squares(A.m(), 0.);
    for (unsigned int c = 0; c < A.n(); ++c)
      for (unsigned int i = 0; i < A.m(); ++i)
        squares[i] += A(i, c) * A(i, c);
    std::vector<unsigned int> chosen;
    std::vector<Vector>       directions;
    Vector                    parts(A.m());
    double                    longest = 0.;
    for (const double square : squares)
      longest = std::max(longest, square);
    while (chosen.size() < std::min(A.n(), A.m()))
      {
        const auto next = first_of_largest(squares);
        if (*next <= relative * relative * longest)
          break;
        const unsigned int row = next - squares.begin();
        *next                  = 0.;
        Vector direction       = rest_of_row(A, row, directions);
        // The squares are differences: what is left may be less.
        if (direction.l2_norm() <= relative * std::sqrt(longest))
          continue;
        direction /= direction.l2_norm();
        A.vmult(parts, direction);
        for (unsigned int i = 0; i < A.m(); ++i)
          squares[i] = std::max(squares[i] - parts[i] * parts[i], 0.);
        squares[row] = 0.;
        chosen.push_back(row);
        directions.push_back(std::move(direction));
      }
    return chosen;
  }
} // namespace lamella
