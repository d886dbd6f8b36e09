// SPDX-License-Identifier: LGPL-2.1-or-later

// Contact without friction on a dense compliance M is a complementarity
// problem: s = M lambda + q >= 0, lambda >= 0, s lambda = 0.

#include <lamella/solve/dense_interface_system.h>
#include <lamella/solve/interface_solver.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

BOOST_AUTO_TEST_SUITE(complementarity)

using namespace lamella;

namespace
{
  struct ComplementarityProblem
  {
    std::vector<double> matrix, q;
  };



  struct ComplementaritySolution
  {
    std::vector<double> lambda;
    std::vector<bool>   active;
    unsigned int        iterations = 0;
  };



  /// The solution from the forces @p start.
  ComplementaritySolution
  solve(const ComplementarityProblem &problem, const PointVectors &start)
  {
    const unsigned int n = problem.q.size();
    PointCompliance    W;
    for (unsigned int i = 0; i < n; ++i)
      W.first.push_back(i + 1);
    W.matrix = problem.matrix;
    DenseInterfaceSystem system(W, W.by_points(problem.q), PointVectors(n));
    const std::vector<std::shared_ptr<const InterfaceLaw>> laws(
      n, std::make_shared<UnilateralContact>());
    const auto found = solve_interface(system, system.points(laws), start, {});
    ComplementaritySolution result;
    result.iterations = found.iterations;
    for (unsigned int i = 0; i < n; ++i)
      {
        result.active.push_back(found.states[i] != PointState::open);
        result.lambda.push_back(result.active[i] ? found.force[i][0] : 0.);
      }
    return result;
  }



  ComplementaritySolution
  solve(const ComplementarityProblem &problem)
  {
    return solve(problem, PointVectors(problem.q.size()));
  }



  /// The entries (i, j) of a symmetric matrix by a function.
  template <typename Entry>
  std::vector<double>
  matrix(const unsigned int n, const Entry &entry)
  {
    std::vector<double> M(n * n);
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        M[j * n + i] = entry(i, j);
    return M;
  }



  std::vector<double>
  noise(const unsigned int n, const unsigned int seed)
  {
    std::mt19937                     engine(seed);
    std::normal_distribution<double> normal;
    std::vector<double>              x(n);
    for (double &value : x)
      value = normal(engine);
    return x;
  }



  /// G^T G + shift of a random G of @p rank rows.
  std::vector<double>
  random_matrix(const unsigned int n,
                const unsigned int rank,
                const unsigned int seed,
                const double       shift)
  {
    const std::vector<double> G = noise(n * rank, seed);
    return matrix(n, [&](const unsigned int i, const unsigned int j) {
      double sum = i == j ? shift : 0.;
      for (unsigned int k = 0; k < rank; ++k)
        sum += G[i * rank + k] * G[j * rank + k];
      return sum;
    });
  }



  /// The compliance w(x_i, x_j) of a cantilever of length and stiffness EI one,
  /// x^2 (3 y - x) / 6 for x <= y, at n points: condition about n^4.
  std::vector<double>
  cantilever(const unsigned int n)
  {
    return matrix(n, [n](const unsigned int i, const unsigned int j) {
      const double x = (std::min(i, j) + 1.) / n, y = (std::max(i, j) + 1.) / n;
      return x * x * (3. * y - x) / 6.;
    });
  }



  std::vector<double>
  slack(const ComplementarityProblem &problem,
        const std::vector<double>    &lambda)
  {
    const unsigned int  n = lambda.size();
    std::vector<double> s = problem.q;
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        s[i] += problem.matrix[j * n + i] * lambda[j];
    return s;
  }



  /// The largest violation of s >= 0 and of s = 0 where active, over the
  /// largest |q|; lambda >= 0 is exact.
  double
  violation(const ComplementarityProblem  &problem,
            const ComplementaritySolution &solution)
  {
    const std::vector<double> s     = slack(problem, solution.lambda);
    double                    worst = 0., size = 0.;
    for (unsigned int i = 0; i < s.size(); ++i)
      {
        BOOST_TEST((solution.active[i] ? solution.lambda[i] > 0. :
                                         solution.lambda[i] == 0.));
        size  = std::max(size, std::abs(problem.q[i]));
        worst = std::max(worst, solution.active[i] ? std::abs(s[i]) : -s[i]);
      }
    return worst / size;
  }



  /// M_AA lambda_A = -q_A by Gauss elimination without pivots, A the bits of
  /// @p set.
  std::vector<double>
  solve_set(const ComplementarityProblem &problem, const unsigned int set)
  {
    const unsigned int  n = problem.q.size();
    std::vector<double> A = problem.matrix, b(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        b[i] = (set >> i & 1) ? -problem.q[i] : 0.;
        for (unsigned int j = 0; j < n; ++j)
          if (!(set >> i & 1) || !(set >> j & 1))
            A[j * n + i] = i == j ? 1. : 0.;
      }
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int i = k + 1; i < n; ++i)
        {
          const double f = A[k * n + i] / A[k * n + k];
          b[i] -= f * b[k];
          for (unsigned int j = k; j < n; ++j)
            A[j * n + i] -= f * A[j * n + k];
        }
    for (unsigned int k = n; k-- > 0;)
      {
        for (unsigned int j = k + 1; j < n; ++j)
          b[k] -= A[j * n + k] * b[j];
        b[k] /= A[k * n + k];
      }
    return b;
  }



  /// The solution by trying all 2^n active sets.
  std::vector<double>
  brute_force(const ComplementarityProblem &problem)
  {
    const unsigned int n = problem.q.size();
    for (unsigned int set = 0; set < 1u << n; ++set)
      {
        const std::vector<double> lambda = solve_set(problem, set),
                                  s      = slack(problem, lambda);
        bool right                       = true;
        for (unsigned int i = 0; i < n; ++i)
          right = right && lambda[i] >= 0. && (set >> i & 1 || s[i] >= 0.);
        if (right)
          return lambda;
      }
    BOOST_FAIL("no active set is right");
    return {};
  }
} // namespace

BOOST_AUTO_TEST_CASE(all_active_sets_tried)
{
  for (unsigned int seed = 0; seed < 200; ++seed)
    {
      const unsigned int           n = 1 + seed % 10;
      const ComplementarityProblem problem{random_matrix(n, n, seed, 0.1),
                                           noise(n, 1000 + seed)};
      const std::vector<double>    due = brute_force(problem),
                                found  = solve(problem).lambda;
      for (unsigned int i = 0; i < n; ++i)
        BOOST_TEST(std::abs(found[i] - due[i]) < 1e-10 * (1. + due[i]));
    }
}



BOOST_AUTO_TEST_CASE(large_and_random)
{
  for (const unsigned int n : {50, 200, 500})
    {
      const ComplementarityProblem  problem{random_matrix(n, n, n, 1e-3),
                                           noise(n, n + 1)};
      const ComplementaritySolution solution = solve(problem);
      BOOST_TEST_MESSAGE(n << " rows: " << solution.iterations
                           << " iterations");
      BOOST_TEST(violation(problem, solution) < 1e-12);
      BOOST_TEST(solution.iterations <= 45);
    }
}



BOOST_AUTO_TEST_CASE(a_cantilever_pressed_on_a_curved_floor)
{
  // q = -x^2 / 2 + r x^4: without contact the beam bends through a floor that
  // falls away from it; and a floor that undulates, so that contact breaks up.
  for (const bool waves : {false, true})
    for (const unsigned int n : {50, 100, 200, 400})
      {
        ComplementarityProblem problem{cantilever(n), {}};
        for (unsigned int i = 0; i < n; ++i)
          {
            const double x = (i + 1.) / n;
            problem.q.push_back(x * x * (0.3 * x * x - 0.1) +
                                (waves ? 0.001 * std::cos(40. * x) : 0.));
          }
        const ComplementaritySolution solution = solve(problem);
        BOOST_TEST_MESSAGE(n << " rows: " << solution.iterations
                             << " iterations");
        BOOST_TEST(violation(problem, solution) < 1e-12);
        BOOST_TEST(solution.iterations <= 45);
      }
}



BOOST_AUTO_TEST_CASE(rows_that_depend_on_each_other)
{
  // Rank 6 and a tiny softness: lambda are the minimum-norm forces, the gaps
  // those of the six modes.
  for (const double softness : {1e-6, 1e-10})
    for (unsigned int seed = 0; seed < 20; ++seed)
      {
        const unsigned int     n = 60;
        ComplementarityProblem problem{random_matrix(n, 6, seed, 6. * softness),
                                       noise(n, seed + 7)};
        // Gaps that forces of both signs would close.
        const std::vector<double> x = noise(n, seed + 99);
        const std::vector<double> M = problem.matrix;
        for (unsigned int i = 0; i < n; ++i)
          {
            problem.q[i] = 0.;
            for (unsigned int j = 0; j < n; ++j)
              problem.q[i] -= M[j * n + i] * x[j];
          }
        const ComplementaritySolution solution = solve(problem);
        BOOST_TEST(violation(problem, solution) < 1e-12);
        BOOST_TEST(solution.iterations <= 60);
      }
}



BOOST_AUTO_TEST_CASE(ties_and_units)
{
  // Rows that are closed by others exactly carry nothing: M = I + e e^T, q from
  // lambda = (1, 0, 2, 0) with s = 0 in the second row.
  const std::vector<double> M =
    matrix(4, [](auto i, auto j) { return i == j ? 2. : 1.; });
  ComplementarityProblem problem{M, {-4., -3., -5., 1.}};
  for (const double length : {1., 1e-6, 1e9})
    for (const double force : {1., 1e6, 1e-9})
      {
        ComplementarityProblem scaled = problem;
        for (double &entry : scaled.matrix)
          entry *= length / force;
        for (double &q : scaled.q)
          q *= length;
        const ComplementaritySolution solution = solve(scaled);
        const std::vector<double>     due{1., 0., 2.};
        for (unsigned int i = 0; i < 4; ++i)
          BOOST_TEST(std::abs(solution.lambda[i] / force - due[i]) < 1e-14);
      }

  // Zero gaps everywhere need no force at all.
  BOOST_TEST(solve({M, {0., 0., 0., 0.}}).lambda == std::vector<double>(4, 0.));
}



BOOST_AUTO_TEST_CASE(a_good_start_is_used)
{
  const unsigned int            n = 200;
  const ComplementarityProblem  problem{random_matrix(n, n, 3, 1e-3),
                                       noise(n, 4)};
  const ComplementaritySolution cold = solve(problem);
  PointVectors                  start(n);
  for (unsigned int i = 0; i < n; ++i)
    start[i][0] = cold.lambda[i];
  const ComplementaritySolution warm = solve(problem, start);
  BOOST_TEST(warm.iterations <= 2u);
  for (unsigned int i = 0; i < n; ++i)
    BOOST_TEST(std::abs(warm.lambda[i] - cold.lambda[i]) < 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()
