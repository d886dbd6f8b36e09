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

  /// Returns the derivatives of section function @p a (number in @p point) by x
  /// and z [1 / length].
  std::array<dealii::Tensor<1, 3>, 2>
  field_derivatives(const SectionPoint &point, const unsigned int a);

  /// Returns the displacement gradient H at @p point of the section at the axis
  /// point number @p k, with the coefficients @p q of the section functions.
  Gradient
  gradient_at(const SectionPoint &point,
              const FieldParts   &q,
              const unsigned int  k);

  /// Returns Green's strain of the displacement gradient @p H, with engineering
  /// shear strains 2 E_ij,
  ///   E_ij = (H_ij + H_ji + sum_c H_ic H_jc) / 2.
  Voigt
  green_strain(const Gradient &H);

  /// Returns the first Piola-Kirchhoff stress S (1 + H), with the @p second
  /// Piola-Kirchhoff stress S and the displacement gradient @p H.
  dealii::Tensor<2, 3>
  first_stress(const Gradient &H, const Voigt &second);

  /// Returns Green's strain as predicted by linearization at the previous
  /// Newton iterate,
  ///   E_ij - sum_c dH_ic dH_jc / 2,
  /// where E is Green's strain of @p H and @p dH the last correction of H.
  Voigt
  predicted_strain(const Gradient &H, const Gradient &dH);

  /// Returns the material tangent, the symmetric derivative of first_stress()
  /// by H for S = C E with the stiffness C of @p law,
  ///   (dE/dH)^T C dE/dH + S_ij delta_cd.
  /// Rows and columns 3 i + c belong to H[i][c]. @p second is S in the second
  /// term, computed from predicted_strain() (mixed integration points:
  /// Magisano, Leonetti and Garcea, Int. J. Numer. Meth. Engng 110, 2017).
  dealii::Tensor<2, 9>
  green_tangent(const Gradient &H, const Voigt &second, const ElasticLaw &law);

  /// Returns the geometric stiffness term S_ij delta_cd of green_tangent().
  dealii::Tensor<2, 9>
  stress_tangent(const Voigt &second);

  /// Converts a Green's strain in the order of Voigt to a tensor E_ij.
  dealii::SymmetricTensor<2, 3>
  strain_tensor(const Voigt &strain);

  /// The polar decomposition F = R U of the deformation gradient F_ci =
  /// delta_ci + H[i][c] into rotation R and right stretch U, U^2 = 1 + 2 E.
  class PolarDecomposition
  {
  public:
    explicit PolarDecomposition(const Gradient &H);

    /// Returns the rotation R.
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

  /// Magnitudes of the rotation and the strain, at a point or over a section.
  struct Stretch
  {
    /// Rotation angle [rad], largest magnitude of a principal Green's strain,
    /// and |E_yy|. Over a section: maxima, for E_yy the root mean square.
    double rotation = 0., strain = 0., along = 0.;
  };
  Stretch
  stretch_of(const Gradient &H);
} // namespace lamella

#endif
