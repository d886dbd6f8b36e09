// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/linear/dense_factors.h>
#include <lamella/solve/dense_interface_system.h>

#include <algorithm>
#include <cmath>

// Linear systems of the contact points by their dense compliance. For v + w =
// q + W (lambda - D w - about), with r = q + W (lambda - about) - v and the
// factors D = L L^T of each point, the symmetric form of (1 + W D) w = r is
//   (1 + L^T W L) y = L^T r,   w = r - W L y,   y = L^T w.
// Linearized laws A dlambda + B dv = r, with the forces lambda_0 of the closed
// points only, are for these points
//   (A + B W) dlambda = r - B (q + W (lambda_0 - about) - v).
namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Returns the lower triangular L with L L^T = @p D; columns of zero pivots
    /// are zero.
    Tensor<2, 3>
    cholesky_factor(const SymmetricTensor<2, 3> &D)
    {
      Tensor<2, 3> L;
      for (unsigned int j = 0; j < 3; ++j)
        for (unsigned int i = j; i < 3; ++i)
          {
            double rest = D[i][j];
            for (unsigned int k = 0; k < j; ++k)
              rest -= L[i][k] * L[j][k];
            if (i == j)
              L[j][j] = std::sqrt(std::max(0., rest));
            else if (L[j][j] > 0.)
              L[i][j] = rest / L[j][j];
          }
      return L;
    }
  } // namespace



  DenseInterfaceSystem::DenseInterfaceSystem(const PointCompliance &W,
                                             const PointVectors    &q,
                                             const PointVectors    &about)
    : W(W)
    , q(q)
    , about(about)
    , v(q)
    , L(q.size())
  {
    double most = 0.;
    for (unsigned int r = 0; r < W.n_rows(); ++r)
      most = std::max(most, W(r, r));
    const auto scale_of = [&](const double diagonal) {
      return 1. / std::sqrt(std::max(diagonal, arithmetic::rounding * most));
    };
    for (unsigned int i = 0; i < W.n_points(); ++i)
      {
        const unsigned int first = W.first[i], size = W.size(i);
        double             tangents = 0.;
        for (unsigned int c = 1; c < size; ++c)
          tangents += W(first + c, first + c) / (size - 1);
        const double normal = scale_of(W(first, first));
        unit.push_back({{normal, size > 1 ? scale_of(tangents) : normal}});
      }
  }



  void
  DenseInterfaceSystem::factorize(const PointStiffness &D)
  {
    const unsigned int  n = W.n_rows();
    std::vector<double> A(std::size_t(n) * n);
    factorized_for.clear();
    for (unsigned int i = 0; i < D.size(); ++i)
      L[i] = cholesky_factor(D[i]);
    for (unsigned int q = 0; q < W.n_points(); ++q)
      for (unsigned int p = q; p < W.n_points(); ++p)
        {
          Tensor<2, 3> block;
          for (unsigned int a = 0; a < W.size(p); ++a)
            for (unsigned int b = 0; b < W.size(q); ++b)
              block[a][b] = W(W.first[p] + a, W.first[q] + b);
          block = transpose(L[p]) * block * L[q];
          for (unsigned int a = 0; a < W.size(p); ++a)
            for (unsigned int b = 0; b < W.size(q); ++b)
              A[std::size_t(W.first[q] + b) * n + W.first[p] + a] =
                block[a][b] + (p == q && a == b ? 1. : 0.);
        }
    factor.emplace(std::move(A), n, "The interior point matrix of contact");
  }



  PointVectors
  DenseInterfaceSystem::lengths_of(const PointVectors &force) const
  {
    PointVectors change = force;
    for (unsigned int i = 0; i < change.size(); ++i)
      change[i] -= about[i];
    PointVectors result = W.times(change);
    for (unsigned int i = 0; i < result.size(); ++i)
      result[i] += q[i];
    return result;
  }



  bool
  DenseInterfaceSystem::move_to(const PointVectors &force)
  {
    v = lengths_of(force);
    return true;
  }



  PointVectors
  DenseInterfaceSystem::solve(const PointVectors &force)
  {
    PointVectors r = lengths_of(force), y = r;
    for (unsigned int i = 0; i < r.size(); ++i)
      {
        r[i] -= v[i];
        y[i] = transpose(L[i]) * r[i];
      }
    std::vector<double> x = W.by_rows(y);
    factor->solve(x);
    y = W.by_points(x);
    for (unsigned int i = 0; i < r.size(); ++i)
      y[i] = L[i] * y[i];
    y = W.times(y);
    for (unsigned int i = 0; i < r.size(); ++i)
      r[i] -= y[i];
    return step = r;
  }



  int
  DenseInterfaceSystem::solve(const std::vector<LinearizedLaw> &laws,
                              const std::vector<Row>           &rows,
                              std::vector<double>              &x)
  {
    const std::size_t   n = rows.size();
    std::vector<double> A(n * n);
    for (std::size_t j = 0; j < n; ++j)
      {
        const auto [q, b] = rows[j];
        for (std::size_t i = 0; i < n; ++i)
          {
            const auto [p, a]        = rows[i];
            const LinearizedLaw &law = laws[p];
            double               sum = p == q ? law.A[a][b] : 0.;
            for (unsigned int k = 0; k < W.size(p); ++k)
              sum += law.B[a][k] * W(W.first[p] + k, W.first[q] + b);
            A[j * n + i] = sum * scale(rows[j]) / scale(rows[i]);
          }
      }
    const DenseLU factor(std::move(A), n);
    const int     sign = factor.sign_of_determinant();
    if (sign != 0)
      factor.solve(x);
    return sign;
  }



  // The factor is kept while the closed points and their compliance stay.
  void
  DenseInterfaceSystem::solve_sticking(const std::vector<LinearizedLaw> &laws,
                                       const std::vector<Row>           &rows,
                                       std::vector<double>              &x)
  {
    const std::size_t                            n = rows.size();
    std::vector<std::pair<unsigned int, double>> matrix_rows;
    for (const Row &row : rows)
      matrix_rows.emplace_back(W.first[row.point] + row.component,
                               laws[row.point].A[row.component][row.component]);
    if (!factor || factorized_for != matrix_rows)
      {
        std::vector<double> A(n * n);
        for (std::size_t j = 0; j < n; ++j)
          {
            const double *const column =
              W.matrix.data() + std::size_t(matrix_rows[j].first) * W.n_rows();
            const double u = scale(rows[j]);
            for (std::size_t i = j; i < n; ++i)
              A[j * n + i] = column[matrix_rows[i].first] * u * scale(rows[i]);
            A[j * n + j] += matrix_rows[j].second;
          }
        factor.emplace(std::move(A), n, "The compliance of the contact rows");
        factorized_for = matrix_rows;
      }
    factor->solve(x);
  }



  // Open points have no unknowns.
  InterfaceStep
  DenseInterfaceSystem::solve(const std::vector<LinearizedLaw> &laws,
                              const PointVectors               &force)
  {
    std::vector<Row> rows;
    InterfaceStep    result;
    bool             slips = false;
    result.force           = force;
    for (unsigned int p = 0; p < laws.size(); ++p)
      {
        slips = slips || laws[p].state == PointState::slip;
        if (laws[p].state == PointState::open)
          result.force[p] = {};
        else
          for (unsigned int a = 0; a < W.size(p); ++a)
            rows.push_back({p, a});
      }
    const PointVectors  lengths = lengths_of(result.force);
    std::vector<double> x;
    for (const Row &row : rows)
      {
        const LinearizedLaw &law = laws[row.point];
        x.push_back(
          (law.residual[row.component] -
           law.B[row.component] * (lengths[row.point] - v[row.point])) /
          scale(row));
      }
    if (slips)
      result.sign = solve(laws, rows, x);
    else if (!rows.empty())
      solve_sticking(laws, rows, x);
    for (std::size_t i = 0; i < rows.size(); ++i)
      result.force[rows[i].point][rows[i].component] += scale(rows[i]) * x[i];
    result.is_solved = result.sign != 0 &&
                       std::isfinite(inner_product(result.force, result.force));
    if (!result.is_solved)
      return result;
    step = lengths_of(result.force);
    for (unsigned int i = 0; i < v.size(); ++i)
      step[i] -= v[i];
    result.change = step;
    return result;
  }



  InterfacePoints
  DenseInterfaceSystem::points(
    const std::vector<std::shared_ptr<const InterfaceLaw>> &law) const
  {
    InterfacePoints result;
    result.law = law;
    for (unsigned int i = 0; i < W.n_points(); ++i)
      {
        result.n_slips.push_back(W.size(i) - 1);
        result.stiffness.push_back(
          {{unit[i][0] * unit[i][0], unit[i][1] * unit[i][1]}});
        result.spring.push_back(result.stiffness.back()[0]);
      }
    result.compliance.resize(W.n_points());
    result.shift.resize(W.n_points());
    result.about = about;
    return result;
  }



  void
  DenseInterfaceSystem::advance(const double t)
  {
    for (unsigned int i = 0; i < v.size(); ++i)
      v[i] += t * step[i];
  }
} // namespace lamella
