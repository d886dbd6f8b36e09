// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_interface_law_h
#define lamella_contact_interface_law_h

#include <lamella/contact/gap_constraints.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <memory>

namespace lamella
{
  /// State of an interface point.
  enum class PointState
  {
    open,
    stick,
    slip
  };

  /// Traction of an interface point for a trial traction z, and its derivatives
  /// (InterfaceLaw::evaluate()). Components are (n, t_1, t_2) [force].
  struct InterfaceResponse
  {
    PointState           state = PointState::open; ///< State of the point.
    dealii::Tensor<1, 3> traction;                 ///< Traction P(z).
    /// Derivative of P by z with constant bound; symmetric.
    dealii::SymmetricTensor<2, 3> tangent;
    /// Derivative of P by the bound.
    dealii::Tensor<1, 3> bound_derivative;
    /// Convex energy (|z|^2 - |z - P(z)|^2) / 2, whose gradient by z is P(z)
    /// [force^2]. The Moreau envelope of the law in terms of the jump is this
    /// energy over the stiffness D, with z = lambda_bar - D jump.
    double energy = 0.;
  };

  /// Bound b of the shear force of a point, and its gradient by the trial
  /// traction.
  struct ShearBound
  {
    double               value = 0.; ///< Bound b(z) >= 0 [force].
    dealii::Tensor<1, 3> gradient;   ///< db/dz.
  };

  /**
   * Law of an interface point: the traction lambda that answers the jump v, the
   * gap and the two slips of a load step, v = (g, s_1, s_2) + a lambda with the
   * compliance a of the law, law_compliance(). The law holds if for any
   * stiffness D > 0 lambda = P(z),  z = lambda - D v, where P is the projection
   * onto the convex set of tractions that belongs to the bound b(z) (Alart and
   * Curnier, Comput. Methods Appl. Mech. Eng. 92 (1991) 353-375). With constant
   * bound, P is the gradient of a convex energy and its derivative symmetric;
   * the derivative of the bound is the unsymmetric part.
   */
  class InterfaceLaw
  {
  public:
    virtual ~InterfaceLaw();

    /// Returns the bound of the shear force for the trial traction @p z, or for
    /// a traction.
    virtual ShearBound
    bound(const dealii::Tensor<1, 3> &z) const = 0;

    /// Returns true if the law also transmits tension, in all directions.
    virtual bool
    is_bilateral() const
    {
      return false;
    }

    /// Returns traction, derivatives and energy for the trial traction @p z and
    /// a constant @p bound of the shear force.
    virtual InterfaceResponse
    evaluate(const dealii::Tensor<1, 3> &z, const double bound) const = 0;
  };

  /// Frictionless contact: v_n >= 0, lambda_n >= 0, v_n lambda_n = 0. With the
  /// compliance a = 1 / eps it is the penalty method, lambda_n = eps max(0,
  /// -g).
  class UnilateralContact : public InterfaceLaw
  {
  public:
    ShearBound
    bound(const dealii::Tensor<1, 3> &z) const override;
    InterfaceResponse
    evaluate(const dealii::Tensor<1, 3> &z, const double bound) const override;
  };

  /// Frictional contact by Coulomb's law: in addition to UnilateralContact,
  ///   |lambda_t| <= mu lambda_n,  v_t = 0 where |lambda_t| < mu lambda_n,
  ///   lambda_t = -mu lambda_n v_t / |v_t| where v_t is not zero.
  class CoulombFriction : public UnilateralContact
  {
  public:
    /// Creates a law with the friction coefficient @p mu.
    explicit CoulombFriction(const double mu)
      : mu(mu)
    {}
    ShearBound
    bound(const dealii::Tensor<1, 3> &z) const override;
    InterfaceResponse
    evaluate(const dealii::Tensor<1, 3> &z, const double bound) const override;

  private:
    const double mu;
  };

  /// Tied points: v = 0 for any traction, P(z) = z. The compliance is that of
  /// an adhesive.
  class TiedInterface : public InterfaceLaw
  {
  public:
    bool
    is_bilateral() const override
    {
      return true;
    }
    ShearBound
    bound(const dealii::Tensor<1, 3> &z) const override;
    InterfaceResponse
    evaluate(const dealii::Tensor<1, 3> &z, const double bound) const override;
  };

  /// Returns the compliance a [length / force] in the contact law of the
  /// constraint @p row: 1 / eps for the method `penalty` with penalty eps, that
  /// of the adhesive of ties in normal or @p tangential direction, otherwise
  /// zero.
  double
  law_compliance(const GapConstraint &row, const bool tangential = false);

  /// Returns the compliance of entry @p number in a list of all gaps, then all
  /// slips, of @p rows.
  double
  law_compliance(const GapConstraints &rows, const unsigned int number);

  /// Returns the law of the constraint @p row.
  std::shared_ptr<const InterfaceLaw>
  law_of(const GapConstraint &row);
} // namespace lamella

#endif
