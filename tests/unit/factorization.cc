// SPDX-License-Identifier: LGPL-2.1-or-later

// The factorization and its halves on matrices whose inverse is known by
// formula.

#include <lamella/base/exceptions.h>
#include <lamella/linear/factorization.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <functional>

BOOST_AUTO_TEST_SUITE(factorization)

using namespace lamella;

namespace
{
  using Entry = std::function<double(unsigned int, unsigned int)>;

  /// A sparse matrix of size n with a place for each entry that is not zero.
  struct Sparse
  {
    Sparse(const unsigned int n, const Entry &entry)
    {
      dealii::DynamicSparsityPattern pattern(n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          if (i == j || entry(i, j) != 0. || entry(j, i) != 0.)
            pattern.add(i, j);
      sparsity.copy_from(pattern);
      matrix.reinit(sparsity);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          if (sparsity.exists(i, j))
            matrix.set(i, j, entry(i, j));
    }

    dealii::SparsityPattern sparsity;
    Matrix                  matrix;
  };



  // I + e e^T, whose inverse is I - e e^T / (n + 1).
  double
  dense(const unsigned int i, const unsigned int j)
  {
    return i == j ? 2. : 1.;
  }



  // {-1, 2, -1}, whose inverse is min(i, j) (n + 1 - max(i, j)) / (n + 1),
  // counted from 1.
  double
  chain(const unsigned int i, const unsigned int j)
  {
    return i == j ? 2. : i + 1 == j || j + 1 == i ? -1. : 0.;
  }



  struct Case
  {
    unsigned int n;
    Entry        entry, inverse;
  };

  std::vector<Case>
  cases()
  {
    std::vector<Case> all;
    for (const unsigned int n : {1, 2, 7, 40})
      {
        all.push_back({n, dense, [n](auto i, auto j) {
                         return (i == j ? 1. : 0.) - 1. / (n + 1.);
                       }});
        all.push_back({n, chain, [n](auto i, auto j) {
                         return (std::min(i, j) + 1.) * (n - std::max(i, j)) /
                                (n + 1.);
                       }});
      }
    return all;
  }



  bool
  failure_is_named(const Sparse &sparse, const unsigned int n)
  {
    try
      {
        factorize(sparse.matrix, "body 'plank'");
      }
    catch (const NumericsError &error)
      {
        const std::string message = error.what();
        return message.find("body 'plank'") != std::string::npos &&
               message.find("pivot ") != std::string::npos &&
               message.find("of " + std::to_string(n)) != std::string::npos &&
               message.find("not positive definite") != std::string::npos;
      }
    return false;
  }
} // namespace

BOOST_AUTO_TEST_CASE(solve)
{
  for (const Case &c : cases())
    {
      const Sparse A(c.n, c.entry);
      const auto   factor = factorize(A.matrix, "the matrix");
      for (unsigned int k = 0; k < c.n; ++k)
        {
          Vector x(c.n);
          x[k] = 3.;
          factor->solve(x);
          for (unsigned int i = 0; i < c.n; ++i)
            BOOST_TEST(std::abs(x[i] - 3. * c.inverse(i, k)) < 1e-12);
        }
    }
}



namespace
{
  /// A functional with entries in every @p step-th DoF from @p first on.
  LinearFunctional
  functional(const unsigned int n,
             const unsigned int first,
             const unsigned int step)
  {
    LinearFunctional row;
    for (unsigned int i = first; i < n; i += step)
      row.add(i, std::cos(1. + first + 2. * i));
    return row;
  }



  /// b_a A^-1 b_c.
  double
  compliance(const Case             &c,
             const LinearFunctional &a,
             const LinearFunctional &b)
  {
    double sum = 0.;
    for (const auto &[i, weight_i] : a.entries())
      for (const auto &[j, weight_j] : b.entries())
        sum += weight_i * c.inverse(i, j) * weight_j;
    return sum;
  }
} // namespace

BOOST_AUTO_TEST_CASE(halves_make_the_whole)
{
  // P^T L^-T (Y lambda) = A^-1 B^T lambda.
  for (const Case &c : cases())
    {
      const Sparse           A(c.n, c.entry);
      const auto             factor = factorize(A.matrix, "the matrix");
      const auto             rows   = factor->solved_rows();
      const LinearFunctional a      = functional(c.n, 0, 1),
                             b      = functional(c.n, c.n / 2, 3);
      rows->append({a});
      rows->append({b});
      BOOST_TEST(rows->size() == 2);
      const Vector x = rows->displacement({2., -3.});
      for (unsigned int i = 0; i < c.n; ++i)
        {
          LinearFunctional unit;
          unit.add(i, 1.);
          const double due =
            2. * compliance(c, unit, a) - 3. * compliance(c, unit, b);
          BOOST_TEST(std::abs(x[i] - due) < 1e-10);
        }
    }
}



BOOST_AUTO_TEST_CASE(compliance_of_rows)
{
  // B A^-1 B^T = Y^T Y with Y = L^-1 P B^T, in two batches of rows with few
  // entries and with many; the chain has a deep elimination tree.
  for (const Case &c : cases())
    {
      const Sparse A(c.n, c.entry);
      const auto   factor = factorize(A.matrix, "the matrix");
      const std::vector<LinearFunctional> all{functional(c.n, 0, c.n),
                                              functional(c.n, c.n / 3, 2),
                                              functional(c.n, c.n - 1, 1),
                                              functional(c.n, 0, 1),
                                              functional(c.n, c.n / 2, c.n)};
      const auto                          rows = factor->solved_rows();
      rows->append({all[0], all[1]});
      const std::vector<double> before = rows->products(0);
      rows->append({all[2], all[3], all[4]});
      const std::vector<double> after = rows->products(2);
      for (unsigned int j = 0; j < 5; ++j)
        for (unsigned int i = 0; i < 5; ++i)
          if (i >= 2 || j < 2)
            {
              const double due = compliance(c, all[i], all[j]),
                           found =
                             i < 2 ? before[2 * j + i] : after[3 * j + i - 2];
              BOOST_TEST(std::abs(found - due) < 1e-11 * (1. + std::abs(due)));
            }
    }
}



BOOST_AUTO_TEST_CASE(only_the_upper_triangle_is_read)
{
  const Sparse A(7, [](const unsigned int i, const unsigned int j) {
    return i > j ? 99. : dense(i, j);
  });
  const auto   factor = factorize(A.matrix, "the matrix");
  Vector       x(7);
  x[2] = 1.;
  factor->solve(x);
  for (unsigned int i = 0; i < 7; ++i)
    BOOST_TEST(std::abs(x[i] - (i == 2 ? 7. / 8. : -1. / 8.)) < 1e-14);
}



BOOST_AUTO_TEST_CASE(matrices_without_a_factor)
{
  // One negative eigenvalue, whatever the order of the pivots.
  BOOST_TEST(failure_is_named(Sparse(4,
                                     [](auto i, auto j) {
                                       return i != j ? 0. : i == 2 ? -3. : 1.;
                                     }),
                              4));
  // Positive diagonal, eigenvalues 3 and -1.
  BOOST_TEST(
    failure_is_named(Sparse(2, [](auto i, auto j) { return i == j ? 1. : 2.; }),
                     2));
  // Singular: a free chain; 1 - 1 = 0 is left for the last pivot, exactly.
  BOOST_TEST(failure_is_named(Sparse(3,
                                     [](auto i, auto j) {
                                       return i == j ? (i == 1 ? 2. : 1.) :
                                                       chain(i, j);
                                     }),
                              3));
  // Zero.
  BOOST_TEST(failure_is_named(Sparse(2, [](auto, auto) { return 0.; }), 2));
}



// A cycle of n unknowns, x_(i+1) = b_i, and then with twice the values: pivots
// off the diagonal, and a determinant of sign (-1)^(n-1). Below the diagonal
// there is nothing but the corner, so a symmetric solver solves another
// problem.
BOOST_AUTO_TEST_CASE(unsymmetric_and_again)
{
  for (const unsigned int n : {4, 5})
    {
      MatrixEntries cycle;
      for (unsigned int i = 0; i < n; ++i)
        {
          cycle.rows.push_back(i + 1);
          cycle.columns.push_back((i + 1) % n + 1);
          cycle.values.push_back(1.);
        }
      const auto factor = analyze_shared(n, cycle, Symmetry::none, "a cycle");
      for (const double value : {1., 2.})
        {
          factor->factorize(std::vector<double>(n, value));
          Vector x(n);
          for (unsigned int i = 0; i < n; ++i)
            x[i] = i;
          factor->solve(x);
          for (unsigned int i = 0; i < n; ++i)
            BOOST_TEST(x[(i + 1) % n] == i / value);
          BOOST_TEST(factor->sign_of_determinant() == (n % 2 == 0 ? -1 : 1));
        }
      BOOST_CHECK_THROW(factor->factorize(std::vector<double>(n, 0.)),
                        NumericsError);
    }
}



BOOST_AUTO_TEST_CASE(condition_of_a_diagonal)
{
  // L = diag(1, 1e3, 10), so (1e3)^2 = 1e6, which here is the exact condition.
  const std::vector<double> d{1., 1e6, 100.};
  const Sparse A(3, [&d](const unsigned int i, const unsigned int j) {
    return i == j ? d[i] : 0.;
  });
  const auto   factor = factorize(A.matrix, "the matrix");
  BOOST_TEST(std::abs(factor->condition_estimate() / 1e6 - 1.) < 1e-12);

  // A lower estimate: the chain of 40 has the condition cot^2(pi/82) = 680.6.
  const Sparse chained(40, chain);
  const double estimate =
    factorize(chained.matrix, "the matrix")->condition_estimate();
  BOOST_TEST(estimate >= 1.);
  BOOST_TEST(estimate < 681.);
}

BOOST_AUTO_TEST_SUITE_END()
