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

    /// Returns the contact points with the @p friction coefficients, exact laws
    /// and no numerical compliance.
    InterfacePoints
    points(const std::vector<double> &friction) const;

    void
    factorize(const PointStiffness &D) override;
    PointVectors
    solve(const PointVectors &force) override;
    InterfaceStep
    solve(const std::vector<LinearizedLaw> &laws,
          const PointVectors               &force) override;
    void
    move_to(const PointVectors &force) override;
    void
    advance(const double t) override;
    PointVectors
    lengths() const override
    {
      return v;
    }

  private:
    /// Returns q + W (@p force - about).
    PointVectors
    lengths_of(const PointVectors &force) const;

    const PointCompliance &W;
    PointVectors           q, about, v, step;
    /// Scale of normal and tangential forces of each point, 1 / sqrt(W_ii).
    std::vector<std::array<double, 2>> unit;
    /// Lower triangular factors L of each point, D = L L^T.
    std::vector<dealii::Tensor<2, 3>> L;
    /// Cholesky factor of 1 + L^T W L.
    std::optional<DenseCholesky> factor;
  };
} // namespace lamella

#endif
