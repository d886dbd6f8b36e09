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

  /// Returns the derivatives by x and z [1 / length] of the section function
  /// number (*point.fields)[@p a] at @p point.
  std::array<dealii::Tensor<1, 3>, 2>
  field_derivatives(const SectionPoint &point, const unsigned int a);

  /// Returns the displacement gradient H at @p point of the section and point
  /// number @p k of the axis. @p q has the amplitudes of the section functions
  /// and their derivatives along the axis.
  Gradient
  gradient_at(const SectionPoint &point,
              const FieldParts   &q,
              const unsigned int  k);

  /// Returns the Green-Lagrange strain of the displacement gradient @p H, with
  /// engineering shear strains 2 E_ij,
  ///   E_ij = (H_ij + H_ji + sum_c H_ic H_jc) / 2.
  Voigt
  green_strain(const Gradient &H);

  /// Returns the part sum_c H_ic H_jc / 2 of green_strain(), as there.
  Voigt
  quadratic_strain(const Gradient &H);

  /// Returns true if det F <= 0, with F = 1 + H^T of the gradient @p H.
  inline bool
  is_inverted(const Gradient &H)
  {
    return !(determinant(dealii::unit_symmetric_tensor<3>() + H) > 0.);
  }

  /// Returns the first Piola-Kirchhoff stress S (1 + H) from the @p second
  /// Piola-Kirchhoff stress S and the displacement gradient @p H.
  dealii::Tensor<2, 3>
  first_stress(const Gradient &H, const Voigt &second);

  /// Returns the Green-Lagrange strain of the gradient @p H as the previous
  /// Newton iterate predicted it by linearization,
  ///   E_ij - sum_c dH_ic dH_jc / 2,
  /// where @p dH is the last correction of H, and E the strain of H.
  Voigt
  predicted_strain(const Gradient &H, const Gradient &dH);

  /// Returns the derivative of first_stress() by the displacement gradient H,
  ///   (dE/dH)^T C dE/dH + S_ij delta_cd,
  /// with the Green-Lagrange strain E and the stiffness C of @p law. Row 3 i +
  /// c belongs to H[i][c], and column 3 j + d to H[j][d]. The stress S is @p
  /// second, for example that of predicted_strain() (mixed integration points:
  /// Magisano, Leonetti and Garcea, Int. J. Numer. Meth. Engng 110, 2017).
  dealii::Tensor<2, 9>
  green_tangent(const Gradient &H, const Voigt &second, const ElasticLaw &law);

  /// Returns the term S_ij delta_cd of green_tangent(), with S = @p second.
  dealii::Tensor<2, 9>
  stress_tangent(const Voigt &second);

  /// Converts the Green-Lagrange @p strain from Voigt notation to a tensor.
  dealii::SymmetricTensor<2, 3>
  strain_tensor(const Voigt &strain);

  /// Converts the @p stress from Voigt notation to a tensor.
  dealii::Tensor<2, 3>
  stress_tensor(const Voigt &stress);

  /// The polar decomposition F = R U of the deformation gradient F_ci =
  /// delta_ci + H[i][c] into a rotation R and the right stretch tensor U.
  class PolarDecomposition
  {
  public:
    /// Computes R and U of the displacement gradient @p H.
    explicit PolarDecomposition(const Gradient &H);

    /// Returns the rotation R as a matrix.
    const dealii::Tensor<2, 3> &
    rotation() const
    {
      return R;
    }

    /// Returns the Cauchy stress in axes that rotate with the material, R^T
    /// sigma R = U S U / det U, from the @p second Piola-Kirchhoff stress S.
    Voigt
    corotated_stress(const Voigt &second) const;

  private:
    dealii::Tensor<2, 3> U, R;
  };

  /// Returns the angle of the rotation matrix @p R, from 0 to pi [rad].
  double
  angle_of(const dealii::Tensor<2, 3> &R);

  /// Rotation and Green-Lagrange strain at a point, or maxima over a section.
  struct Stretch
  {
    double rotation = 0., ///< Rotation angle [rad].
      strain        = 0., ///< Largest absolute value of a principal strain.
      along = 0.; ///< Axial strain |E_yy|; root mean square over a section.
  };
  /// Returns rotation and strains at a point with displacement gradient @p H.
  Stretch
  stretch_of(const Gradient &H);
} // namespace lamella

#endif
