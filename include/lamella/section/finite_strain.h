// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_finite_strain_h
#define lamella_section_finite_strain_h

#include <lamella/material/elasticity.h>
#include <lamella/section/section_answer.h>
#include <lamella/section/section_point.h>

#include <deal.II/base/tensor.h>

namespace lamella
{
  /// The gradient of a displacement in the body's axes, a row a direction:
  /// H[i][c] = d u_c / d x_i. No unit.
  using Gradient = dealii::Tensor<2, 3>;

  /// Of the field number @p a at @p point of a section d Phi / dx and
  /// d Phi / dz [1 / length].
  std::array<dealii::Tensor<1, 3>, 2>
  derivatives_of_field(const SectionPoint &point, const unsigned int a);

  /// H at @p point with the coefficients @p q of the fields there, in their
  /// order, at station @p k.
  Gradient
  gradient_at(const SectionPoint &point,
              const FieldParts   &q,
              const unsigned int  k);

  /// Green's strain of the gradient @p H,
  ///   E_ij = (H_ij + H_ji + sum_c H_ic H_jc) / 2,
  /// in the order of Voigt, shears twice.
  Voigt
  green_strain(const Gradient &H);

  /// The first Piola-Kirchhoff stress S (1 + H), a row a direction, where
  /// @p second is the second one, S, in the order of Voigt.
  dealii::Tensor<2, 3>
  first_stress(const Gradient &H, const Voigt &second);

  /// Returns the strain that the linearization at the last iterate predicted,
  ///   E_ij - sum_c dH_ic dH_jc / 2,
  /// with the correction @p dH that led to @p H. For a zero correction it is E.
  Voigt
  predicted_strain(const Gradient &H, const Gradient &dH);

  /**
   * The derivative of first_stress() by H where S = C E is that of @p law: row
   * and column 3 i + c of H[i][c],
   *   (dE/dH)^T C dE/dH + S_ij delta_cd,
   * symmetric. @p second is the S of the second term, that of
   * predicted_strain() (mixed integration points: Magisano, Leonetti and
   * Garcea, Int. J. Numer. Meth. Engng 110, 2017).
   */
  dealii::Tensor<2, 9>
  green_tangent(const Gradient &H, const Voigt &second, const ElasticLaw &law);

  /// S_ij delta_cd of the second stress @p second, in the same order: what a
  /// stress that does not change adds where H does.
  dealii::Tensor<2, 9>
  stress_tangent(const Voigt &second);

  /// The numbers of green_strain() as a tensor, E_ij.
  dealii::SymmetricTensor<2, 3>
  strain_tensor(const Voigt &strain);

  /**
   * A deformation F_ci = delta_ci + H[i][c] as a stretch and then a turn,
   * F = R U with U^2 = 1 + 2 E, the polar decomposition.
   */
  class PolarDecomposition
  {
  public:
    explicit PolarDecomposition(const Gradient &H);

    /// R, which turns with the material.
    const dealii::Tensor<2, 3> &
    turn() const
    {
      return R;
    }

    /// R^T sigma R of Cauchy's stress sigma = F S F^T / det F, where @p second
    /// is the second Piola-Kirchhoff stress S: the true stress in axes that
    /// turn with the material, U S U / det U. In the order of Voigt.
    Voigt
    turned_stress(const Voigt &second) const;

  private:
    dealii::Tensor<2, 3> U, R;
  };

  /// The angle of the rotation @p R, 0 to pi [rad].
  double
  angle_of(const dealii::Tensor<2, 3> &R);

  /// How far the material turns and stretches.
  struct Stretch
  {
    /// [rad], the largest principal value of |E|, and |E_yy|. Over the points
    /// of a section the largest, and the root mean square of E_yy.
    double turn = 0., strain = 0., along = 0.;
  };
  Stretch
  stretch_of(const Gradient &H);
} // namespace lamella

#endif
