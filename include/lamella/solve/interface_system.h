// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_interface_system_h
#define lamella_solve_interface_system_h

#include <lamella/contact/interface_law.h>
#include <lamella/solve/point_compliance.h>

#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <memory>
#include <vector>

namespace lamella
{
  /// Symmetric, positive semidefinite 3 x 3 matrix D of each contact point
  /// [force / length], which maps gap and slips to contact forces.
  using PointStiffness = std::vector<dealii::SymmetricTensor<2, 3>>;

  /// Linearized law A dlambda + B dv = r of a contact point, with the change
  /// dlambda of its force and dv of gap and slips. A includes the compliance of
  /// the law.
  struct LinearizedLaw
  {
    /// State of the point: A = 1, B = 0, r = -lambda for an open one, A = D d,
    /// B = D for a sticking one, with the compliance d and stiffness D.
    PointState           state = PointState::open;
    dealii::Tensor<2, 3> A,        ///< Factor of the change of force.
      B;                           ///< Factor of the change of gap and slips.
    dealii::Tensor<1, 3> residual; ///< Right-hand side r.
  };

  /// Solution of equilibrium with the linearized law of each point.
  struct InterfaceStep
  {
    bool         is_solved = false; ///< False if the matrix is singular.
    PointVectors force,             ///< Contact force of each point.
      change;                       ///< Change of gaps and slips.
    /// Sign of the determinant of the matrix; -1 for an unstable equilibrium
    /// (InterfaceSolution::stability).
    int sign = 1;
  };

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

    /// Solves equilibrium with the linearized @p laws of all points about the
    /// contact forces @p force. The matrix need not be symmetric. Throws
    /// NumericsError as factorize() does.
    virtual InterfaceStep
    solve(const std::vector<LinearizedLaw> &laws,
          const PointVectors               &force) = 0;

    /// Adds the fraction @p t of the last result of solve() to the iterate.
    virtual void
    advance(const double t) = 0;

    /// Sets the iterate to the equilibrium under the contact forces @p force,
    /// or to the initial state if these are its forces. Returns false if that
    /// is not an equilibrium.
    virtual bool
    move_to(const PointVectors &force) = 0;

    /// Returns the iterate of gaps and slips v, without compliance of the law.
    virtual PointVectors
    lengths() const = 0;
  };

  /// Contact points of an InterfaceSystem with their laws, in which the lengths
  ///   v + d (lambda - lambda_bar) + a lambda_bar
  /// stand for gap and slips, with the compliance a of the law, the numerical
  /// compliance d >= a, and an estimate lambda_bar of the force. All vectors
  /// have one entry per point.
  struct InterfacePoints
  {
    std::vector<unsigned int> n_slips; ///< Number of tangents: 0, 1 or 2.
    std::vector<std::shared_ptr<const InterfaceLaw>> law; ///< Law.
    std::vector<double> compliance; ///< Numerical compliance d.
    /// Lengths (d - a) lambda_bar.
    PointVectors shift;
    /// Stiffness that relates forces and lengths of a point in normal and
    /// tangential direction, the inverse of its local compliance.
    std::vector<std::array<double, 2>> stiffness;
    /// Stiffness of the springs at the point that give the starting point, in
    /// the order of that of the bodies under forces on all points.
    std::vector<double> spring;
    /// Lengths of open points up to this value are rounding errors of zero.
    double closed = 0.;
    /// Contact forces at the beginning, in equilibrium with the bodies.
    PointVectors about;

    /// Returns the lengths of point @p i for gap and slips @p v and the contact
    /// force @p force.
    dealii::Tensor<1, 3>
    lengths(const unsigned int          i,
            const dealii::Tensor<1, 3> &v,
            const dealii::Tensor<1, 3> &force) const
    {
      return v + compliance[i] * force - shift[i];
    }
  };
} // namespace lamella

#endif
