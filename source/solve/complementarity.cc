// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/linear/dense_cholesky.h>
#include <lamella/solve/complementarity.h>
#include <lamella/solve/dense_interface_system.h>
#include <lamella/solve/interior_point.h>

#include <algorithm>
#include <cmath>
#include <limits>

// Linear complementarity problem: block principal pivoting (Kostreva, Linear
// Algebra Appl. 21 (1978) 207-215), the interior point method if that cycles,
// and single pivots of largest index as a safeguard (Murty's rule; Judice and
// Pires, Comput. Oper. Res. 21 (1994) 587-596).
// The problem is strictly convex, so the solution is unique. Pivoting starts
// from the set of the previous problem, and ends with exact signs of all
// entries; the interior point only gives a better set.
namespace lamella
{
  namespace
  {
    // Rounding of an s_i over the sum of its terms.
    constexpr double rounding = arithmetic::rounding;
    // Rounds of pivoting before the interior-point method, and rounds without
    // fewer wrong constraints before single pivots.
    constexpr unsigned int first_rounds = 10, patience = 3;



    /// The problem scaled to a unit diagonal and a largest |q_i| of one, with
    /// the current active set.
    class Search
    {
    public:
      Search(const ComplementarityProblem &problem,
             const std::vector<bool>      &start);

      /// Pivots until the set is correct; returns false after @p max_rounds or,
      /// without @p single_pivots, if the number of wrong constraints
      /// stagnates.
      bool
      pivot(const std::size_t max_rounds, const bool single_pivots);

      /// Sets the active set to that of the interior point method.
      void
      find_interior();

      ComplementaritySolution
      solution() const;

    private:
      /// Solves M_AA lambda_A = -q_A and sets s = M lambda + q.
      void
      solve_active();

      /// Returns the constraints whose lambda or s has the wrong sign.
      std::vector<unsigned int>
      violating_rows() const;

      /// s = M x + q.
      void
      multiply(const std::vector<double> &x, std::vector<double> &s) const;

      unsigned int            n;
      std::vector<double>     M, q, tolerance, unit;
      std::vector<double>     lambda, s;
      std::vector<bool>       active;
      ComplementaritySolution counts;
    };



    // Symmetric scaling S M S with S = diag(M_ii)^-1/2, so units do not matter.
    Search::Search(const ComplementarityProblem &problem,
                   const std::vector<bool>      &start)
      : n(problem.q.size())
      , M(problem.matrix)
      , q(problem.q)
      , tolerance(n)
      , unit(n)
      , lambda(n)
      , s(n)
      , active(start)
    {
      std::vector<double> scale(n);
      double              size = 0.;
      for (unsigned int i = 0; i < n; ++i)
        {
          scale[i] = 1. / std::sqrt(M[i * n + i]);
          size     = std::max(size, std::abs(q[i] * scale[i]));
        }
      for (unsigned int i = 0; i < n; ++i)
        {
          q[i] *= scale[i] / size;
          tolerance[i] = problem.tolerance * scale[i] / size;
          unit[i]      = scale[i] * size;
          for (unsigned int j = 0; j < n; ++j)
            M[i * n + j] *= scale[i] * scale[j];
        }
    }



    void
    Search::multiply(const std::vector<double> &x, std::vector<double> &s) const
    {
      s = q;
      for (unsigned int j = 0; j < n; ++j)
        if (x[j] != 0.)
          {
            const double *const column = M.data() + std::size_t(j) * n;
            for (unsigned int i = 0; i < n; ++i)
              s[i] += column[i] * x[j];
          }
    }



    // Cholesky factor of M_AA, positive definite by the regularization.
    void
    Search::solve_active()
    {
      std::vector<unsigned int> set;
      for (unsigned int i = 0; i < n; ++i)
        if (active[i])
          set.push_back(i);
      const std::size_t   size = set.size();
      std::vector<double> block(size * size), x(size);
      for (std::size_t j = 0; j < size; ++j)
        {
          x[j] = -q[set[j]];
          for (std::size_t i = j; i < size; ++i)
            block[j * size + i] = M[std::size_t(set[j]) * n + set[i]];
        }
      const DenseCholesky factor(std::move(block),
                                 size,
                                 "The compliance of the contact rows");

      // One step of iterative refinement: s then has its own rounding only.
      std::fill(lambda.begin(), lambda.end(), 0.);
      for (unsigned int pass = 0; pass < 2; ++pass)
        {
          factor.solve(x);
          for (std::size_t i = 0; i < size; ++i)
            lambda[set[i]] += x[i];
          multiply(lambda, s);
          for (std::size_t i = 0; i < size; ++i)
            x[i] = -s[set[i]];
        }
      ++counts.pivot_rounds;
    }



    // Signs up to rounding of the sum that forms s_i.
    std::vector<unsigned int>
    Search::violating_rows() const
    {
      double sum = 1.;
      for (const double l : lambda)
        sum += std::abs(l);
      std::vector<unsigned int> wrong;
      for (unsigned int i = 0; i < n; ++i)
        if (active[i] ? lambda[i] < 0. : s[i] < -tolerance[i] - rounding * sum)
          wrong.push_back(i);
      return wrong;
    }



    // Exchanges all wrong constraints at once, only the last one in turn when
    // their number has not fallen for `patience` rounds.
    bool
    Search::pivot(const std::size_t max_rounds, const bool single_pivots)
    {
      std::size_t  fewest = n + 1;
      unsigned int tries  = patience;
      for (std::size_t round = 0; round < max_rounds; ++round)
        {
          solve_active();
          std::vector<unsigned int> wrong = violating_rows();
          if (wrong.empty())
            return true;
          if (wrong.size() < fewest)
            {
              fewest = wrong.size();
              tries  = patience;
            }
          else if (tries > 0)
            --tries;
          else if (single_pivots)
            wrong = {wrong.back()};
          else
            return false;
          for (const unsigned int i : wrong)
            active[i] = !active[i];
        }
      return false;
    }



    // Contact without friction: one row per point.
    void
    Search::find_interior()
    {
      PointCompliance W;
      PointVectors    gaps(n);
      for (unsigned int i = 0; i < n; ++i)
        {
          W.first.push_back(i + 1);
          gaps[i][0] = q[i];
        }
      W.matrix = M;
      DenseInterfaceSystem  system(W, gaps, PointVectors(n));
      const InterfacePoints points = system.points(std::vector<double>(n, 0.));
      const PointVectors    force =
        solve_by_interior_point(system, points, [this](const Round &) {
          ++counts.interior_iterations;
        });
      for (unsigned int i = 0; i < n; ++i)
        active[i] = force[i][0] > 0.;
    }



    ComplementaritySolution
    Search::solution() const
    {
      ComplementaritySolution result = counts;
      result.lambda.resize(n);
      result.active.resize(n);
      for (unsigned int i = 0; i < n; ++i)
        {
          result.lambda[i] = std::max(0., lambda[i]) * unit[i];
          result.active[i] = lambda[i] > 0.;
        }
      return result;
    }
  } // namespace



  // lambda = 0 solves the problem if no q_i is negative.
  ComplementaritySolution
  solve_complementarity(const ComplementarityProblem &problem,
                        const std::vector<bool>      &start)
  {
    ComplementaritySolution none;
    none.lambda.assign(problem.q.size(), 0.);
    none.active.assign(problem.q.size(), false);
    if (std::all_of(problem.q.begin(),
                    problem.q.end(),
                    [&problem](const double q) {
                      return q >= -problem.tolerance;
                    }))
      return none;

    Search search(problem, start);
    if (!search.pivot(first_rounds, false))
      {
        search.find_interior();
        search.pivot(10 * problem.q.size() + 100, true);
      }
    return search.solution();
  }
} // namespace lamella
