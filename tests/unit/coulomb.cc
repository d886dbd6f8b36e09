// SPDX-License-Identifier: LGPL-2.1-or-later

// Coulomb's law on dense compliances: points by hand, random problems up to
// conditions of 1e10, rows that depend on each other. What is checked is the
// law itself, line by line, and not the map that was solved.

#include <lamella/linear/dense_factors.h>
#include <lamella/solve/dense_interface_system.h>
#include <lamella/solve/interface_solver.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

BOOST_AUTO_TEST_SUITE(coulomb)

using namespace lamella;
using dealii::Tensor;

namespace
{
  /// W = Q diag Q^T of a random orthogonal Q, with diagonal entries from 1 down
  /// to 1 / condition; of so many points with so many rows.
  PointCompliance
  random_compliance(const unsigned int points,
                    const unsigned int rows_a_point,
                    const double       condition,
                    std::mt19937      &random)
  {
    std::normal_distribution<double> normal;
    PointCompliance                  W;
    for (unsigned int i = 0; i < points; ++i)
      W.first.push_back(W.first.back() + rows_a_point);
    const unsigned int               n = W.n_rows();
    std::vector<std::vector<double>> Q(n, std::vector<double>(n));
    for (unsigned int j = 0; j < n; ++j)
      {
        for (double &x : Q[j])
          x = normal(random);
        for (unsigned int pass = 0; pass < 2; ++pass)
          for (unsigned int k = 0; k < j; ++k)
            {
              double along = 0.;
              for (unsigned int i = 0; i < n; ++i)
                along += Q[k][i] * Q[j][i];
              for (unsigned int i = 0; i < n; ++i)
                Q[j][i] -= along * Q[k][i];
            }
        double size = 0.;
        for (const double x : Q[j])
          size += x * x;
        for (double &x : Q[j])
          x /= std::sqrt(size);
      }
    W.matrix.assign(std::size_t(n) * n, 0.);
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          W(i, j) +=
            std::pow(condition, -double(k) / (n - 1)) * Q[k][i] * Q[k][j];
    return W;
  }



  std::shared_ptr<const InterfaceLaw>
  law_with(const double friction, const bool has_slips)
  {
    if (has_slips)
      return std::make_shared<CoulombFriction>(friction);
    return std::make_shared<UnilateralContact>();
  }



  CoulombProblem
  random_problem(const unsigned int points,
                 const unsigned int rows_a_point,
                 const double       condition,
                 const double       friction,
                 const unsigned int seed)
  {
    std::mt19937                     random(seed);
    std::normal_distribution<double> normal;
    CoulombProblem                   problem;
    problem.compliance =
      random_compliance(points, rows_a_point, condition, random);
    std::vector<double> q(problem.compliance.n_rows());
    for (double &x : q)
      x = normal(random);
    problem.q = problem.compliance.by_points(q);
    problem.law.assign(points, law_with(friction, rows_a_point > 1));
    return problem;
  }



  /// By how much @p force breaks the law of @p problem, in forces and lengths
  /// over the largest of each.
  double
  law_violation(const CoulombProblem &problem,
                const double          mu,
                const PointVectors   &force)
  {
    PointVectors v      = problem.compliance.times(force);
    double       length = largest_component(problem.q), worst = 0.;
    for (unsigned int i = 0; i < v.size(); ++i)
      v[i] += problem.q[i];
    length                = std::max(length, largest_component(v));
    const double strength = std::max(largest_component(force), 1e-300);
    for (unsigned int i = 0; i < v.size(); ++i)
      {
        const double n = force[i][0], t = tangential_norm(force[i]),
                     slip = tangential_norm(v[i]);
        const bool stays  = t < mu * n - 1e-7 * strength;
        worst             = std::max({worst,
                                      -n / strength,
                                      -v[i][0] / length,
                                      (t - mu * n) / strength,
                                      n * std::abs(v[i][0]) / (strength * length),
                          stays ? slip / length : 0.});
        // Against the slip, as long as there is one.
        const Tensor<1, 3> against =
          slip * tangential_part(force[i]) + mu * n * tangential_part(v[i]);
        worst = std::max(worst, against.norm() / (strength * length));
      }
    return worst;
  }



  CoulombProblem
  one_point(const double friction, const Tensor<1, 3> &q)
  {
    CoulombProblem problem;
    problem.compliance = {{0, 3}, {2., 0., 0., 0., 1., 0., 0., 0., 1.}};
    problem.q          = {q};
    problem.law        = {law_with(friction, true)};
    return problem;
  }
} // namespace



BOOST_AUTO_TEST_CASE(one_point_by_hand)
{
  // Open; sticks; slips along (3, 4) / 5, with mu times a normal force of 1/2.
  const PointVectors none(1);
  const auto         open =
    solve_coulomb(one_point(0.3, Tensor<1, 3>({1., 5., 5.})), none);
  BOOST_TEST((open.states[0] == PointState::open));
  BOOST_TEST(open.force[0].norm() == 0.);
  const auto stick =
    solve_coulomb(one_point(0.3, Tensor<1, 3>({-1., 0.06, 0.08})), none);
  BOOST_TEST((stick.states[0] == PointState::stick));
  BOOST_TEST((stick.force[0] - Tensor<1, 3>({0.5, -0.06, -0.08})).norm() <
             1e-12);
  const auto slip =
    solve_coulomb(one_point(0.3, Tensor<1, 3>({-1., 0.6, 0.8})), none);
  BOOST_TEST((slip.states[0] == PointState::slip));
  BOOST_TEST((slip.force[0] - Tensor<1, 3>({0.5, -0.09, -0.12})).norm() <
             1e-12);
  BOOST_TEST(slip.stability == 1);
}



BOOST_AUTO_TEST_CASE(the_law_holds_in_a_thousand_random_problems)
{
  unsigned int n = 0;
  for (const unsigned int rows : {2u, 3u})
    for (const double condition : {1e2, 1e4, 1e6, 1e8, 1e10})
      for (const double friction : {0.3, 0.6, 1., 1.5})
        for (unsigned int seed = 0; seed < 25; ++seed, ++n)
          {
            const auto problem =
              random_problem(8, rows, condition, friction, seed);
            const auto found = solve_coulomb(problem, PointVectors(8));
            BOOST_TEST(found.error < 1e-11);
            BOOST_TEST(law_violation(problem, friction, found.force) < 1e-6);
          }
  BOOST_TEST(n == 1000u);
}



BOOST_AUTO_TEST_CASE(an_interior_point_finds_the_closed_points)
{
  // Without friction the solution is unique, the minimum of a convex energy.
  // The compliance is that of solve_coulomb().
  for (unsigned int seed = 0; seed < 20; ++seed)
    {
      const auto           problem = random_problem(40, 1, 1e3, 0., seed);
      const auto           exact   = solve_coulomb(problem, PointVectors(40));
      DenseInterfaceSystem system(problem.compliance,
                                  problem.q,
                                  PointVectors(40));
      unsigned int         n = 0;
      const PointVectors   force =
        solve_by_interior_point(system,
                                softened(system.points(problem.law),
                                         CoulombRules().compliance,
                                         PointVectors(40)),
                                [&n](const Round &) { ++n; });
      BOOST_TEST(n < 30u);
      for (unsigned int i = 0; i < 40; ++i)
        BOOST_TEST((force[i][0] == 0.) ==
                   (exact.states[i] == PointState::open));
    }
}



BOOST_AUTO_TEST_CASE(rows_that_depend_on_each_other)
{
  // Forty points that only three others move: rank 9.
  std::mt19937                     random(7);
  std::normal_distribution<double> normal;
  CoulombProblem                   problem;
  PointCompliance                 &W = problem.compliance;
  for (unsigned int i = 0; i < 40; ++i)
    W.first.push_back(W.first.back() + 3);
  std::vector<std::vector<double>> of_rank(9, std::vector<double>(120));
  for (auto &x : of_rank)
    for (double &y : x)
      y = normal(random);
  W.matrix.assign(120 * 120, 0.);
  std::vector<double> q(120, 0.);
  for (const auto &x : of_rank)
    {
      const double load = normal(random);
      for (unsigned int i = 0; i < 120; ++i)
        {
          q[i] -= load * x[i];
          for (unsigned int j = 0; j < 120; ++j)
            W(i, j) += x[i] * x[j];
        }
    }
  problem.q = W.by_points(q);
  problem.law.assign(40, law_with(0.4, true));
  const auto found = solve_coulomb(problem, PointVectors(40));
  BOOST_TEST(largest_component(found.force) > 0.);
  BOOST_TEST(found.error < 1e-11);
  BOOST_TEST(law_violation(problem, 0.4, found.force) < 1e-8);
}



BOOST_AUTO_TEST_CASE(units_and_frames_do_not_matter)
{
  const auto problem = random_problem(10, 3, 1e4, 0.5, 11);
  const auto found   = solve_coulomb(problem, PointVectors(10));
  // Lengths in other units, forces too; tangents turned by 0.7 rad.
  const double length = 1e3, force = 1e-4, c = std::cos(0.7), s = std::sin(0.7);
  CoulombProblem other = problem;
  for (double &entry : other.compliance.matrix)
    entry *= length / force;
  const auto turned = [&](const Tensor<1, 3> &x) {
    return Tensor<1, 3>({x[0], c * x[1] + s * x[2], -s * x[1] + c * x[2]});
  };
  for (unsigned int i = 0; i < 10; ++i)
    other.q[i] = length * turned(problem.q[i]);
  PointCompliance in_frame = other.compliance;
  for (unsigned int j = 0; j < 30; ++j)
    {
      PointVectors column(10);
      for (unsigned int i = 0; i < 30; ++i)
        column[i / 3][i % 3] = other.compliance(i, j);
      for (unsigned int i = 0; i < 10; ++i)
        for (unsigned int k = 0; k < 3; ++k)
          in_frame(3 * i + k, j) = turned(column[i])[k];
    }
  for (unsigned int i = 0; i < 30; ++i)
    {
      PointVectors row(10);
      for (unsigned int j = 0; j < 30; ++j)
        row[j / 3][j % 3] = in_frame(i, j);
      for (unsigned int j = 0; j < 10; ++j)
        for (unsigned int k = 0; k < 3; ++k)
          other.compliance(i, 3 * j + k) = turned(row[j])[k];
    }
  const auto again = solve_coulomb(other, PointVectors(10));
  for (unsigned int i = 0; i < 10; ++i)
    BOOST_TEST((again.force[i] - force * turned(found.force[i])).norm() <
               1e-10 * force * largest_component(found.force));
}



BOOST_AUTO_TEST_CASE(signs_of_determinants)
{
  const auto sign = [](const std::vector<double> &matrix) {
    return DenseLU(matrix, matrix.size() == 4 ? 2 : 3).sign_of_determinant();
  };
  BOOST_TEST(sign({1., 0., 0., 1.}) == 1);
  BOOST_TEST(sign({0., 1., 1., 0.}) == -1);
  BOOST_TEST(sign({1., 2., 2., 1.}) == -1);
  BOOST_TEST(sign({1., 2., 2., 4.}) == 0);
  BOOST_TEST(sign({0., 1., 0., 0., 0., 1., 1., 0., 0.}) == 1);
}

BOOST_AUTO_TEST_CASE(rows_that_depend_share_a_force_evenly)
{
  // Three rows that measure the same, of which the third rubs: any forces that
  // sum to the same will do, the least are equal. Another row stands alone.
  const std::vector<double>
    A = {2., 2., 2., 0., 2., 2., 2., 0., 2., 2., 2., 0., 0., 0., 0., 5.},
    d = {2., 2., 2., 5.};
  const std::vector<double> x = solve_dependent(A, d, {6., 6., 6., 10.}, 1e-9);
  for (const unsigned int i : {0, 1, 2})
    BOOST_TEST(std::abs(x[i] - 1.) < 1e-12);
  BOOST_TEST(std::abs(x[3] - 2.) < 1e-12);
  // Rows of other sizes are weighted: what depends is seen in small ones, too.
  const std::vector<double> B = {2., 2e-4, 2e-4, 2e-8};
  const std::vector<double> y =
    solve_dependent(B, {2., 2e-8}, {4., 4e-4}, 1e-9);
  BOOST_TEST(std::abs(y[0] - 1.) < 1e-12);
  BOOST_TEST(std::abs(y[1] - 1e4) < 1e-8);
  // Independent ones come out as of any other solver.
  const std::vector<double> z =
    solve_dependent({2., 1., -3., 4.}, {2., 4.}, {-1., 9.}, 1e-9);
  BOOST_TEST(std::abs(z[0] - 23. / 11.) < 1e-14);
  BOOST_TEST(std::abs(z[1] - 19. / 11.) < 1e-14);
}

BOOST_AUTO_TEST_SUITE_END()
