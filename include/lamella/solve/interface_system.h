// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_interface_system_h
#define lamella_solve_interface_system_h

#include <lamella/solve/point_compliance.h>

#include <deal.II/base/symmetric_tensor.h>

#include <vector>

namespace lamella
{
  /// Symmetric, positive semidefinite 3 x 3 matrix D of each contact point
  /// [force / length], which maps gap and slips to contact forces.
  using PointStiffness = std::vector<dealii::SymmetricTensor<2, 3>>;

  /// Equilibrium of the bodies, reduced to the contact points: gaps and slips v
  /// as affine function of the contact forces. The iterate v need not satisfy
  /// it for the current forces; each solution of a linear system removes the
  /// difference. There are two linear-algebra back ends: a sparse matrix
  /// with penalty terms (SparseInterfaceSystem), and a dense compliance of the
  /// points (DenseInterfaceSystem).
  class InterfaceSystem
  {
  public:
    virtual ~InterfaceSystem() = default;

    /// Factorizes the operator with the stiffness @p D at the points. Throws
    /// NumericsError if it is not positive definite.
    virtual void
    factorize(const PointStiffness &D) = 0;

    /// Returns the change w of gaps and slips for which v + w are those of the
    /// contact forces @p force - D w, with the last factorized D.
    virtual PointVectors
    solve(const PointVectors &force) = 0;

    /// Adds the fraction @p t of the last result of solve() to the iterate.
    virtual void
    advance(const double t) = 0;

    /// Returns the iterate of gaps and slips v, without compliance of the law.
    virtual PointVectors
    lengths() const = 0;
  };

  /// Contact points of an InterfaceSystem with their law. All vectors have one
  /// entry per point.
  struct InterfacePoints
  {
    std::vector<unsigned int> n_slips;  ///< Number of tangents: 0, 1 or 2.
    std::vector<double>       friction; ///< Friction coefficient mu.
    /// Compliance d of the law: v + d lambda answers the contact force lambda.
    std::vector<double> compliance;
    /// Stiffness of the springs at the point that give the starting point, in
    /// the order of that of the bodies under forces on all points.
    std::vector<double> spring;
  };
} // namespace lamella

#endif
