// SPDX-License-Identifier: LGPL-2.1-or-later

// A sparse matrix times many columns is what it is times each of them.

#include <lamella/linear/factor_row.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

BOOST_AUTO_TEST_SUITE(columns)

using namespace lamella;

BOOST_AUTO_TEST_CASE(one_by_one)
{
  constexpr unsigned int         m = 9, n = 13;
  dealii::DynamicSparsityPattern pattern(m, n);
  for (unsigned int i = 0; i < m; ++i)
    for (unsigned int j = i % 4; j < n; j += 3)
      pattern.add(i, j);
  dealii::SparsityPattern sparsity;
  sparsity.copy_from(pattern);
  Matrix A(sparsity);
  for (auto &entry : A)
    entry.value() = std::cos(1. + entry.row() + 3. * entry.column());
  for (const unsigned int count : {1, 15, 16, 17, 40})
    {
      dealii::LAPACKFullMatrix<double> X(n, count);
      for (unsigned int c = 0; c < count; ++c)
        for (unsigned int i = 0; i < n; ++i)
          X(i, c) = std::sin(2. + i + 5. * c);
      const auto found = times_columns(A, X);
      BOOST_TEST(found.m() == m);
      BOOST_TEST(found.n() == count);
      for (unsigned int c = 0; c < count; ++c)
        {
          Vector x(&X(0, c), &X(0, c) + n), wanted(m);
          A.vmult(wanted, x);
          for (unsigned int i = 0; i < m; ++i)
            BOOST_TEST(std::abs(found(i, c) - wanted[i]) < 1e-14);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
