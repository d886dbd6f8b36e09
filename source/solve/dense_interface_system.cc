// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/dense_interface_system.h>

#include <algorithm>
#include <cmath>

// Linear systems of the contact points by their dense compliance. For v + w =
// q + W (lambda - D w - about), with r = q + W (lambda - about) - v and the
// factors D = L L^T of each point, the symmetric form of (1 + W D) w = r is
//   (1 + L^T W L) y = L^T r,   w = r - W L y,   y = L^T w.
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
  {}



  void
  DenseInterfaceSystem::factorize(const PointStiffness &D)
  {
    const unsigned int  n = W.n_rows();
    std::vector<double> A(std::size_t(n) * n);
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
  DenseInterfaceSystem::solve(const PointVectors &force)
  {
    PointVectors change = force;
    for (unsigned int i = 0; i < change.size(); ++i)
      change[i] -= about[i];
    PointVectors r = W.times(change), y = r;
    for (unsigned int i = 0; i < r.size(); ++i)
      {
        r[i] += q[i] - v[i];
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



  void
  DenseInterfaceSystem::advance(const double t)
  {
    for (unsigned int i = 0; i < v.size(); ++i)
      v[i] += t * step[i];
  }
} // namespace lamella
