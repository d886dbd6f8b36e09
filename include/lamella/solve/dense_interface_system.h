// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_dense_interface_system_h
#define lamella_solve_dense_interface_system_h

#include <lamella/linear/dense_cholesky.h>
#include <lamella/solve/interface_system.h>

#include <optional>
#include <vector>

namespace lamella
{
  /// Equilibrium by a dense compliance W of the points:
  ///   v = q + W (lambda - about).
  class DenseInterfaceSystem : public InterfaceSystem
  {
  public:
    /// The iterate is v = @p q at the forces @p about. Keeps a reference to
    /// @p W.
    DenseInterfaceSystem(const PointCompliance &W,
                         const PointVectors    &q,
                         const PointVectors    &about);

    void
    factorize(const PointStiffness &D) override;
    PointVectors
    solve(const PointVectors &force) override;
    void
    advance(const double t) override;
    PointVectors
    lengths() const override
    {
      return v;
    }

  private:
    const PointCompliance &W;
    PointVectors           q, about, v, step;
    /// Lower triangular factors L of each point, D = L L^T.
    std::vector<dealii::Tensor<2, 3>> L;
    /// Cholesky factor of 1 + L^T W L.
    std::optional<DenseCholesky> factor;
  };
} // namespace lamella

#endif
