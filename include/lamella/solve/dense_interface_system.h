// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_dense_interface_system_h
#define lamella_solve_dense_interface_system_h

#include <lamella/linear/dense_factors.h>
#include <lamella/solve/interface_system.h>

#include <array>
#include <optional>
#include <utility>
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

    /// Returns the contact points with the laws @p law and no numerical
    /// compliance.
    InterfacePoints
    points(const std::vector<std::shared_ptr<const InterfaceLaw>> &law) const;

    void
    factorize(const PointStiffness &D) override;
    PointVectors
    solve(const PointVectors &force) override;
    InterfaceStep
    solve(const std::vector<LinearizedLaw> &laws,
          const PointVectors               &force) override;
    bool
    move_to(const PointVectors &force) override;
    void
    advance(const double t) override;
    PointVectors
    lengths() const override
    {
      return v;
    }

  private:
    /// Component of a point.
    struct Row
    {
      unsigned int point, component;
    };

    /// Returns q + W (@p force - about).
    PointVectors
    lengths_of(const PointVectors &force) const;
    double
    scale(const Row &row) const
    {
      return unit[row.point][row.component > 0];
    }
    /// Solves A dlambda + B dv = r with dv = W dlambda for the components
    /// @p rows; @p x is r, then dlambda, both scaled. Returns the sign of the
    /// determinant, 0 if the matrix is singular.
    int
    solve(const std::vector<LinearizedLaw> &laws,
          const std::vector<Row>           &rows,
          std::vector<double>              &x);
    /// Solves (A / D + W) dlambda = r / D where no point slips, B = D.
    void
    solve_sticking(const std::vector<LinearizedLaw> &laws,
                   const std::vector<Row>           &rows,
                   std::vector<double>              &x);

    const PointCompliance &W;
    PointVectors           q, about, v, step;
    /// Scale of normal and tangential forces of each point, 1 / sqrt(W_ii).
    std::vector<std::array<double, 2>> unit;
    /// Lower triangular factors L of each point, D = L L^T.
    std::vector<dealii::Tensor<2, 3>> L;
    /// Cholesky factor of 1 + L^T W L, or of the matrix of solve_sticking().
    std::optional<DenseCholesky> factor;
    /// Matrix rows and diagonals A / D of the latter factor.
    std::vector<std::pair<unsigned int, double>> factorized_for;
  };
} // namespace lamella

#endif
