// SPDX-License-Identifier: LGPL-2.1-or-later

// The factorization by dense blocks: a matrix whose inverse is known by
// formula, and against CHOLMOD's of the same terms, with constraints and
// springs that couple blocks far apart.

#include <lamella/base/exceptions.h>
#include <lamella/linear/block_factorization.h>
#include <lamella/linear/factorization.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numeric>
#include <random>

BOOST_AUTO_TEST_SUITE(block_factorization)

using namespace lamella;

namespace
{
  /// Elements of four nodes along a chain; node i has sizes[i % n] DoFs.
  DenseBlocks
  chain_of(const unsigned int               n_elements,
           const std::vector<unsigned int> &sizes)
  {
    DenseBlocks        blocks;
    const unsigned int n = 3 * n_elements + 1;
    blocks.first         = {0};
    for (unsigned int i = 0; i < n; ++i)
      blocks.first.push_back(blocks.first.back() + sizes[i % sizes.size()]);
    for (unsigned int e = 0; e < n_elements; ++e)
      blocks.cliques.push_back({3 * e, 3 * e + 3, 3 * e + 1, 3 * e + 2});
    return blocks;
  }



  /// X X^T + I on each element, X of random numbers, row by row; @p shift is
  /// added to the diagonal.
  StiffnessTerms
  random_terms(const DenseBlocks &blocks, const double shift = 0.)
  {
    const DofIndex n = blocks.first.back();
    return {n,
            dealii::complete_index_set(n),
            [blocks, shift](const bool, const auto &use) {
              std::mt19937                           generator(7);
              std::uniform_real_distribution<double> uniform(-1., 1.);
              for (const auto &clique : blocks.cliques)
                {
                  StiffnessBlock block;
                  for (const unsigned int g : clique)
                    for (DofIndex d = blocks.first[g]; d < blocks.first[g + 1];
                         ++d)
                      block.columns.push_back(d);
                  const unsigned int         m = block.columns.size();
                  dealii::FullMatrix<double> X(m), A(m);
                  for (unsigned int i = 0; i < m; ++i)
                    for (unsigned int j = 0; j < m; ++j)
                      X(i, j) = uniform(generator);
                  X.mTmult(A, X);
                  for (unsigned int i = 0; i < m; ++i)
                    {
                      block.rows = {block.columns[i]};
                      block.values.clear();
                      for (unsigned int j = 0; j < m; ++j)
                        block.values.push_back(A(i, j) +
                                               (i == j ? 1. + shift : 0.));
                      use(block);
                    }
                }
            },
            {}};
  }



  Vector
  some_vector(const unsigned int n, const double phase)
  {
    Vector v(n);
    for (unsigned int i = 0; i < n; ++i)
      v[i] = std::cos(phase + 2. * i);
    return v;
  }



  LinearFunctional
  row_of(const std::vector<DofIndex> &dofs)
  {
    LinearFunctional row;
    for (const DofIndex dof : dofs)
      row.add(dof, std::cos(1. + 2. * dof));
    return row;
  }



  void
  check_same(const Vector &found, const Vector &wanted)
  {
    Vector difference = found;
    difference -= wanted;
    BOOST_TEST(difference.linfty_norm() < 1e-12 * wanted.linfty_norm());
  }
} // namespace

BOOST_AUTO_TEST_CASE(known_inverse)
{
  // {-1, 2, -1}, whose inverse is min(i, j) (n + 1 - max(i, j)) / (n + 1),
  // counted from 1, in blocks of two and of five.
  for (const std::vector<unsigned int> &sizes :
       {std::vector<unsigned int>{2}, {1, 5}, {3, 1, 2}})
    {
      DenseBlocks blocks = chain_of(5, sizes);
      // Neighbors couple, all along the chain.
      blocks.cliques.clear();
      for (unsigned int g = 0; g + 2 < blocks.first.size(); ++g)
        blocks.cliques.push_back({g, g + 1});
      const unsigned int   n = blocks.first.back();
      const StiffnessTerms terms{n,
                                 dealii::complete_index_set(n),
                                 [n](const bool, const auto &use) {
                                   for (unsigned int i = 0; i < n; ++i)
                                     {
                                       StiffnessBlock block;
                                       block.rows = {i};
                                       for (unsigned int j = i == 0 ? 0 : i - 1;
                                            j < std::min(n, i + 2);
                                            ++j)
                                         {
                                           block.columns.push_back(j);
                                           block.values.push_back(i == j ? 2. :
                                                                           -1.);
                                         }
                                       use(block);
                                     }
                                 },
                                 {}};
      const auto factor = factorize_blocks(terms, blocks, Constraints(), "A");
      for (unsigned int k = 0; k < n; ++k)
        {
          Vector x(n);
          x[k] = 3.;
          factor->solve(x);
          for (unsigned int i = 0; i < n; ++i)
            BOOST_TEST(std::abs(x[i] - 3. * (std::min(i, k) + 1.) *
                                         (n - std::max(i, k)) / (n + 1.)) <
                       1e-12);
        }
      BOOST_TEST(factor->largest_diagonal() == 2.);
    }
}



BOOST_AUTO_TEST_CASE(as_cholmod)
{
  // The same terms by both, with DoFs that follow others, some of them far
  // away, and springs across the whole chain.
  for (const unsigned int n_elements : {1, 2, 9})
    {
      const DenseBlocks blocks = chain_of(n_elements, {4, 7, 1, 6, 6});
      const DofIndex    n      = blocks.first.back();
      StiffnessTerms    terms  = random_terms(blocks);
      terms.springs            = {{row_of({0, 3, n - 2, n - 1}), 5.},
                                  {row_of({1, n / 2, n - 3}), 0.3}};
      Constraints constraints;
      constraints.add_line(2);
      constraints.add_line(n / 2 + 1);
      constraints.add_entry(n / 2 + 1, 0, 0.5);
      constraints.add_entry(n / 2 + 1, n - 4, -0.25);
      constraints.close();
      const auto by_blocks = factorize_blocks(terms, blocks, constraints, "A");
      const auto matrix    = assemble_serial(terms, constraints);
      const auto sparse    = matrix->factorize("A");

      std::vector<Vector> loads{some_vector(n, 0.), some_vector(n, 1.)};
      for (Vector &load : loads)
        constraints.set_zero(load);
      std::vector<Vector> x = loads, y = loads;
      by_blocks->solve_all(x);
      sparse->solve_all(y);
      for (unsigned int k = 0; k < loads.size(); ++k)
        {
          constraints.set_zero(x[k]);
          constraints.set_zero(y[k]);
          check_same(x[k], y[k]);
        }

      const auto rows = by_blocks->solved_rows(), due = sparse->solved_rows();
      for (const auto &set : {rows.get(), due.get()})
        {
          set->append({row_of({0, 1, n / 2}), row_of({n - 1})});
          set->append({row_of({n / 2 - 1, n - 3})});
        }
      const std::vector<double> found  = rows->products(0),
                                wanted = due->products(0);
      for (unsigned int k = 0; k < wanted.size(); ++k)
        BOOST_TEST(std::abs(found[k] - wanted[k]) < 1e-12);
      check_same(rows->displacement({1., -2., 3.}),
                 due->displacement({1., -2., 3.}));
      const double greatest = matrix->diagonal().linfty_norm();
      BOOST_TEST(std::abs(by_blocks->largest_diagonal() - greatest) <
                 1e-13 * greatest);
    }
}



BOOST_AUTO_TEST_CASE(size_is_told_first)
{
  // Of one element every entry of the lower triangle has a place, blocks on the
  // diagonal have both halves.
  const DenseBlocks        blocks = chain_of(1, {2, 3, 4, 5});
  std::vector<std::string> told;
  SolverMonitor            monitor;
  monitor.factor_sized = [&](const FactorSize &size) {
    told.push_back("size");
    const double half = (14. * 14. - 4. - 9. - 16. - 25.) / 2.;
    BOOST_TEST(size.non_zeros == half + 4. + 9. + 16. + 25.);
    BOOST_TEST(size.bytes == 8. * size.non_zeros);
  };
  monitor.assembled = [&] { told.push_back("assembled"); };
  factorize_blocks(random_terms(blocks), blocks, Constraints(), "A", monitor);
  const std::vector<std::string> due{"size", "assembled"};
  BOOST_TEST(told == due, boost::test_tools::per_element());
}



BOOST_AUTO_TEST_CASE(failure_is_named)
{
  const DenseBlocks blocks = chain_of(3, {2, 3});
  const auto        named  = [&](const NotPositiveDefinite &error) {
    const std::string message = error.what();
    return error.dof < blocks.first.back() &&
           message.find("body 'plank'") != std::string::npos &&
           message.find("not positive definite") != std::string::npos;
  };
  for (const double shift : {-1e3, std::nan("")})
    BOOST_CHECK_EXCEPTION(factorize_blocks(random_terms(blocks, shift),
                                           blocks,
                                           Constraints(),
                                           "body 'plank'"),
                          NotPositiveDefinite,
                          named);
}

BOOST_AUTO_TEST_SUITE_END()
