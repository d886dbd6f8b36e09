// SPDX-License-Identifier: LGPL-2.1-or-later

// Eigenpairs of A v = mu B v by ARPACK, with the operator B^-1 A. It is
// symmetric in the inner products of B (mode 2) and of A, if A is definite
// (mode 3, shift zero). deal.II's ArpackSolver has only mode 3: buckling, with
// an indefinite A, needs mode 2.

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/linear/eigenpairs.h>

#include <deal.II/lac/arpack_solver.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// The data of dsaupd and dseupd, in their order and with their names.
    struct Arpack
    {
      int                 ido     = 0;
      char                bmat[2] = "G", which[3] = "LA", howmany[2] = "A";
      unsigned int        n, nev;
      double              tol, sigma = 0.;
      std::vector<double> resid;
      int                 ncv, ldv;
      std::vector<double> v;
      std::vector<int>    iparam = std::vector<int>(11, 0),
                       ipntr     = std::vector<int>(14, 0);
      std::vector<double> workd, workl;
      int                 lworkl, info = 1;

      Arpack(const BlockVector       &start,
             const unsigned int       n_pairs,
             const int                mode,
             const LanczosParameters &parameters)
        : n(start.size())
        , nev(n_pairs)
        , tol(parameters.tolerance)
        , resid(start.begin(), start.end())
        , ncv(parameters.vectors > 0 ? parameters.vectors : 2 * n_pairs + 10)
        , ldv(n)
        , v(std::size_t(n) * ncv)
        , workd(3 * std::size_t(n))
        , workl(ncv * (ncv + 8))
        , lworkl(workl.size())
      {
        iparam[0] = 1; // exact shifts
        iparam[2] = parameters.restarts;
        iparam[6] = mode;
      }

      /// Performs dsaupd until it wants an operator or ends.
      void
      advance()
      {
        dsaupd_(&ido,
                bmat,
                &n,
                which,
                &nev,
                &tol,
                resid.data(),
                &ncv,
                v.data(),
                &ldv,
                iparam.data(),
                ipntr.data(),
                workd.data(),
                workl.data(),
                &lworkl,
                &info);
      }

      /// Returns the part of the work array that @p pointer of dsaupd is.
      double *
      part(const unsigned int pointer)
      {
        return &workd[ipntr[pointer] - 1];
      }

      /// Returns the converged eigenvalues, ascending (mode 3: their inverses);
      /// vectors are in v.
      std::vector<double>
      extract()
      {
        int                 rvec = 1;
        std::vector<int>    select(ncv, 1);
        std::vector<double> values(nev);
        dseupd_(&rvec,
                howmany,
                select.data(),
                values.data(),
                v.data(),
                &ldv,
                &sigma,
                bmat,
                &n,
                which,
                &nev,
                &tol,
                resid.data(),
                &ncv,
                v.data(),
                &ldv,
                iparam.data(),
                ipntr.data(),
                workd.data(),
                workl.data(),
                &lworkl,
                &info);
        values.resize(std::min<std::size_t>(nev, iparam[4]));
        return values;
      }
    };



    BlockVector
    read(const double *const from, const BlockVector &like)
    {
      BlockVector result(like);
      std::copy_n(from, result.size(), result.begin());
      return result;
    }



    /// Writes what @p arpack asks for: the product with the matrix of the inner
    /// product, or with B^-1 A.
    void
    answer(const Eigenproblem &problem, const BlockVector &like, Arpack &arpack)
    {
      const BlockVector x = read(arpack.part(0), like);
      BlockVector       y;
      if (problem.in_product_of_A)
        // Known once x is a vector of the basis (1, not -1).
        y = arpack.ido == 1 ? read(arpack.part(2), like) : problem.times_A(x);
      else if (arpack.ido == 2)
        y = problem.times_B(x);
      else
        {
          // In mode 2 the product A x replaces x.
          y = problem.times_A(x);
          std::copy(y.begin(), y.end(), arpack.part(0));
        }
      if (arpack.ido != 2)
        y = problem.solve_B(y);
      std::copy(y.begin(), y.end(), arpack.part(1));
    }



    /// Scales the vectors of @p found to unit length in the inner product of
    /// @p product, and appends their products to @p products, which has those
    /// of the first ones.
    void
    append_products(const Operator           &product,
                    Eigenpairs               &found,
                    std::vector<BlockVector> &products)
    {
      while (products.size() < found.vectors.size())
        {
          BlockVector &v = found.vectors[products.size()];
          products.push_back(product(v));
          const double size = std::sqrt(v * products.back());
          v /= size;
          products.back() /= size;
        }
    }



    /// Returns the @p n largest Ritz pairs in the basis of @p arpack.
    Eigenpairs
    ritz_pairs(const Eigenproblem &problem,
               const BlockVector  &like,
               const unsigned int  n,
               const Arpack       &arpack)
    {
      Eigenpairs pairs;
      for (int k = 0; k < arpack.iparam[4]; ++k)
        pairs.vectors.push_back(
          read(&arpack.v[std::size_t(k) * arpack.n], like));
      pairs.values.resize(pairs.vectors.size());
      refine_by_rayleigh_ritz(problem, pairs);
      pairs.values.resize(std::min<std::size_t>(n, pairs.values.size()));
      pairs.vectors.resize(pairs.values.size());
      return pairs;
    }
  } // namespace



  BlockVector
  random_vector(const BlockVector &like, const unsigned int seed)
  {
    std::mt19937                           random(seed);
    std::uniform_real_distribution<double> anything(-1., 1.);
    BlockVector                            result(like);
    for (double &entry : result)
      entry = anything(random);
    return result;
  }



  Eigenpairs
  largest_eigenpairs(const Eigenproblem      &problem,
                     const BlockVector       &start,
                     const unsigned int       n,
                     const LanczosParameters &parameters)
  {
    Arpack arpack(start, n, problem.in_product_of_A ? 3 : 2, parameters);
    for (arpack.advance(); arpack.ido != 99; arpack.advance())
      answer(problem, start, arpack);
    // 1: the number of restarts is reached; -9: A is zero; -9999: the basis,
    // of iparam[4] vectors, spans all that A excites.
    constexpr int start_is_zero = -9, exhausted = -9999;
    if (arpack.info == exhausted && arpack.iparam[4] > 0)
      return ritz_pairs(problem, start, n, arpack);
    if (arpack.info < 0 && arpack.info != start_is_zero)
      throw NumericsError(
        "linear.eigenvalues-not-found: The eigenvalues could not be computed "
        "(ARPACK's error " +
        std::to_string(arpack.info) +
        "): the stiffness may not be positive definite at this state, or the "
        "mesh is too coarse for so many modes.");
    Eigenpairs result;
    if (arpack.info < 0 || arpack.iparam[4] == 0)
      return result;
    // Ascending; mode 3 returns 1 / mu.
    const std::vector<double> values = arpack.extract();
    for (unsigned int i = 0; i < values.size(); ++i)
      {
        const unsigned int k =
          problem.in_product_of_A ? i : values.size() - 1 - i;
        result.values.push_back(problem.in_product_of_A ? 1. / values[k] :
                                                          values[k]);
        result.vectors.push_back(
          read(&arpack.v[std::size_t(k) * arpack.n], start));
      }
    return result;
  }



  void
  add_missing_eigenpairs(const Eigenproblem      &problem,
                         const BlockVector       &start,
                         const LanczosParameters &parameters,
                         Eigenpairs              &found)
  {
    // Different eigenvalues, not one and its rounding; and the accuracy that
    // tells whether one is missing.
    constexpr double   same = arithmetic::quadrature_tolerance, coarse = 1e-3;
    const unsigned int n = found.values.size();
    std::vector<BlockVector> products;
    Eigenproblem             rest = problem;
    // Found eigenvectors are invariant: the projected operator is symmetric.
    rest.solve_B = [&](const BlockVector &f) {
      BlockVector u = problem.solve_B(f);
      for (unsigned int i = 0; i < products.size(); ++i)
        u.add(-(products[i] * u), found.vectors[i]);
      return u;
    };
    while (true)
      {
        append_products(problem.in_product_of_A ? problem.times_A :
                                                  problem.times_B,
                        found,
                        products);
        // The old start has no part in the rest of a multiple eigenvalue.
        const BlockVector   other  = random_vector(start, 1 + products.size());
        std::vector<double> sorted = found.values;
        std::sort(sorted.rbegin(), sorted.rend());
        Eigenpairs next = largest_eigenpairs(rest, other, 1, {coarse, 10, 20});
        if (next.values.empty() ||
            next.values[0] <= (1. + same) * sorted[n - 1])
          break;
        next = largest_eigenpairs(
          rest, other, 1, {parameters.tolerance, 10, parameters.restarts});
        if (next.values.empty())
          break;
        found.values.push_back(next.values[0]);
        found.vectors.push_back(next.vectors[0]);
      }
    refine_by_rayleigh_ritz(problem, found);
    found.values.resize(n);
    found.vectors.resize(n);
  }



  void
  refine_by_rayleigh_ritz(const Eigenproblem &problem, Eigenpairs &pairs)
  {
    const unsigned int       n = pairs.vectors.size();
    LAPACKFullMatrix<double> A(n), B(n);
    for (unsigned int j = 0; j < n; ++j)
      {
        const BlockVector Av = problem.times_A(pairs.vectors[j]),
                          Bv = problem.times_B(pairs.vectors[j]);
        for (unsigned int i = 0; i < n; ++i)
          {
            A(i, j) = pairs.vectors[i] * Av;
            B(i, j) = pairs.vectors[i] * Bv;
          }
        if (!(B(j, j) > 0.))
          throw NumericsError("linear.not-positive-eigenproblem: The stiffness "
                              "is not positive definite at this state.");
      }
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < i; ++j)
        {
          A(i, j) = A(j, i) = 0.5 * (A(i, j) + A(j, i));
          B(i, j) = B(j, i) = 0.5 * (B(i, j) + B(j, i));
        }
    std::vector<dealii::Vector<double>> c(n);
    A.compute_generalized_eigenvalues_symmetric(B, c);
    const std::vector<BlockVector> old = pairs.vectors;
    for (unsigned int k = 0; k < n; ++k)
      {
        const unsigned int from = n - 1 - k; // LAPACK's values ascend.
        pairs.values[k]         = A.eigenvalue(from).real();
        pairs.vectors[k]        = 0.;
        for (unsigned int i = 0; i < n; ++i)
          pairs.vectors[k].add(c[from][i], old[i]);
      }
  }
} // namespace lamella
