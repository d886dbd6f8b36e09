// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_frame_strains_h
#define lamella_body_frame_strains_h

#include <deal.II/base/tensor.h>

#include <array>

namespace lamella
{
  // Kinematics of rigid cross-sections with finite rotations (Reissner, Simo):
  // rotation R and displacement r of the center of the section, in body axes. R
  // is given by a quaternion Q = (Q_0, Q_x, Q_y, Q_z), which need not have unit
  // length, since it is interpolated between nodes:
  //   R v = Q (0, v) Q* / |Q|^2.
  // The results and their derivatives do not depend on |Q|, and are objective.

  using Quaternion = dealii::Tensor<1, 4>;

  /// Returns exp(theta / 2), the rotation by the angle |theta| about @p theta.
  Quaternion
  quaternion_of(const dealii::Tensor<1, 3> &theta);

  /// Returns the rotation vector of @p q, with an angle from 0 to pi [rad].
  dealii::Tensor<1, 3>
  rotation_vector_of(const Quaternion &q);

  /// Returns the product a b, the rotation @p b followed by @p a.
  Quaternion
  compose_rotations(const Quaternion &a, const Quaternion &b);

  /// Returns dq / d theta for a spin theta after @p q: dq = (0, theta) q / 2.
  std::array<dealii::Tensor<1, 3>, 4>
  spin_derivative(const Quaternion &q);

  /// Returns the rotation matrix R(Q).
  dealii::Tensor<2, 3>
  rotation_of(const Quaternion &Q);

  /// Functions f_k of n numbers with their first and second derivatives.
  template <unsigned int n_functions, int n>
  struct Derivatives
  {
    std::array<double, n_functions>               value{};
    std::array<dealii::Tensor<1, n>, n_functions> first;
    std::array<dealii::Tensor<2, n>, n_functions> second;
  };

  /// Strains of a beam section (axis y) as functions of the quaternion Q of its
  /// rotation R, its derivative Q' along y, and r':
  ///   Gamma = R^T (e_y + r') - e_y,
  ///   kappa = vec(R^T R') = 2 vec(Q* Q') / |Q|^2,
  /// with shears Gamma_x, Gamma_z, curvatures kappa_x, kappa_z and twist
  /// kappa_y [1 / length]; the seventh strain is kappa_y^2 / 2. Gamma_y,
  /// kappa_x and kappa_z are replaced by
  ///   Gamma_y + (Gamma_x^2 + Gamma_z^2) / 2,
  ///   kappa_x - kappa_y Gamma_x,   kappa_z - kappa_y Gamma_z.
  /// With (x^2 + z^2) kappa_y^2 / 2 these add the stretch of axial fibers that
  /// shear and twist incline to the normal of the section,
  ///   [(Gamma_x + kappa_y z)^2 + (Gamma_z - kappa_y x)^2] / 2,
  /// which matters for sandwiches with a soft core and for twisted strips.
  /// @p dQ and @p dr are the derivatives of Q and r along y.
  using FrameStrains = Derivatives<7, 11>;
  FrameStrains
  frame_strains(const Quaternion           &Q,
                const Quaternion           &dQ,
                const dealii::Tensor<1, 3> &dr);

  /// Returns R(@p Q) @p v with its derivatives by (Q, v).
  using RotatedVector = Derivatives<3, 7>;
  RotatedVector
  rotated_vector(const Quaternion &Q, const dealii::Tensor<1, 3> &v);
} // namespace lamella

#endif
