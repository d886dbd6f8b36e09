// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_finite_strain_h
#define lamella_section_finite_strain_h

#include <lamella/material/elasticity.h>
#include <lamella/section/section_operator.h>
#include <lamella/section/section_point.h>

#include <deal.II/base/tensor.h>

namespace lamella
{
  /// Displacement gradient in body axes, H[i][c] = d u_c / d x_i [no unit].
  using Gradient = dealii::Tensor<2, 3>;

  /// Returns d Phi / dx and d Phi / dz [1 / length] of field @p a at @p point.
  std::array<dealii::Tensor<1, 3>, 2>
  field_derivatives(const SectionPoint &point, const unsigned int a);

  /// Returns H at @p point with the coefficients @p q at station @p k.
  Gradient
  gradient_at(const SectionPoint &point,
              const FieldParts   &q,
              const unsigned int  k);

  /// Returns Green's strain of @p H, order of Voigt, shears twice,
  ///   E_ij = (H_ij + H_ji + sum_c H_ic H_jc) / 2.
  Voigt
  green_strain(const Gradient &H);

  /// Returns the first Piola-Kirchhoff stress S (1 + H), one row per direction,
  /// from the @p second, S in the order of Voigt.
  dealii::Tensor<2, 3>
  first_stress(const Gradient &H, const Voigt &second);

  /// Returns the strain that the linearization at the last iterate predicted,
  ///   E_ij - sum_c dH_ic dH_jc / 2,
  /// with the correction @p dH that led to @p H. For a zero correction it is E.
  Voigt
  predicted_strain(const Gradient &H, const Gradient &dH);

  /// Returns the symmetric derivative of first_stress() by H for S = C E, with
  /// row and column 3 i + c for H[i][c] and C of @p law,
  ///   (dE/dH)^T C dE/dH + S_ij delta_cd.
  /// @p second is the S of the second term, that of predicted_strain() (mixed
  /// integration points: Magisano, Leonetti and Garcea, Int. J. Numer. Meth.
  /// Engng 110, 2017).
  dealii::Tensor<2, 9>
  green_tangent(const Gradient &H, const Voigt &second, const ElasticLaw &law);

  /// Returns the geometric part S_ij delta_cd of green_tangent().
  dealii::Tensor<2, 9>
  stress_tangent(const Voigt &second);

  /// Returns green_strain() as a tensor, E_ij.
  dealii::SymmetricTensor<2, 3>
  strain_tensor(const Voigt &strain);

  /// The polar decomposition F = R U of the deformation F_ci = delta_ci +
  /// H[i][c], with the stretch U, U^2 = 1 + 2 E.
  class PolarDecomposition
  {
  public:
    explicit PolarDecomposition(const Gradient &H);

    /// Returns R, the rotation of the material.
    const dealii::Tensor<2, 3> &
    rotation() const
    {
      return R;
    }

    /// Returns R^T sigma R = U S U / det U, order of Voigt: Cauchy's stress
    /// sigma = F S F^T / det F in axes that rotate with the material. @p second
    /// is S.
    Voigt
    corotated_stress(const Voigt &second) const;

  private:
    dealii::Tensor<2, 3> U, R;
  };

  /// Returns the angle of the rotation @p R, 0 to pi [rad].
  double
  angle_of(const dealii::Tensor<2, 3> &R);

  /// Measures of rotation and stretch of the material.
  struct Stretch
  {
    /// Angle [rad], largest principal value of |E|, and |E_yy|; the largest
    /// over a section, for E_yy the root mean square.
    double rotation = 0., strain = 0., along = 0.;
  };
  Stretch
  stretch_of(const Gradient &H);
} // namespace lamella

#endif
