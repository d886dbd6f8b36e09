// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_frame_strains_h
#define lamella_body_frame_strains_h

#include <deal.II/base/tensor.h>

#include <array>

namespace lamella
{
  // Kinematics of a section with finite rotation that keeps its shape except
  // for warping (Reissner, Simo), by its rotation R and the place r of its
  // center, in body axes. The quaternion Q = (Q_0, Q_x, Q_y, Q_z) of R has any
  // length, as interpolated unit quaternions of nodes have:
  //   R v = Q (0, v) Q* / |Q|^2.
  // The results and their derivatives do not depend on |Q|, and are objective.

  using Quaternion = dealii::Tensor<1, 4>;

  /// Returns exp(theta / 2): the rotation by |theta| about @p theta [rad].
  Quaternion
  quaternion_of(const dealii::Tensor<1, 3> &theta);

  /// Returns the rotation vector of @p q, of angle 0 to pi [rad].
  dealii::Tensor<1, 3>
  rotation_vector_of(const Quaternion &q);

  /// Returns the rotation @p b followed by @p a.
  Quaternion
  compose_rotations(const Quaternion &a, const Quaternion &b);

  /// Returns dq / d theta for a spin theta after @p q: dq = (0, theta) q / 2.
  std::array<dealii::Tensor<1, 3>, 4>
  spin_derivative(const Quaternion &q);

  /// Returns R(Q).
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

  /**
   * Strains of a section about its axis y as functions of (Q, Q', r'), in this
   * order:
   *   Gamma = R^T (e_y + r') - e_y,
   *   kappa = vec(R^T R') = 2 vec(Q* Q') / |Q|^2,
   * with shears Gamma_x, Gamma_z [no unit], curvatures kappa_x, kappa_z and
   * twist kappa_y [1 / length]; and kappa_y^2 / 2 as the seventh. Gamma_y,
   * kappa_x and kappa_z are replaced by
   *   Gamma_y + (Gamma_x^2 + Gamma_z^2) / 2,
   *   kappa_x - kappa_y Gamma_x,   kappa_z - kappa_y Gamma_z.
   * With r^2 times the seventh these add the stretch of axial fibers tilted
   * against the section's normal by shear and twist,
   *   [(Gamma_x + kappa_y z)^2 + (Gamma_z - kappa_y x)^2] / 2,
   * small for thick homogeneous sections; but it stretches the faces of a
   * sandwich whose core shears, bends it under twist, and stiffens twisted
   * strips. frame_strains() takes the rotation @p Q, and the derivatives @p dQ
   * and @p dr along y of Q and of the center's displacement.
   */
  using FrameStrains = Derivatives<7, 11>;
  FrameStrains
  frame_strains(const Quaternion           &Q,
                const Quaternion           &dQ,
                const dealii::Tensor<1, 3> &dr);

  /// Returns R(@p Q) @p v as a function of (Q, v).
  using RotatedVector = Derivatives<3, 7>;
  RotatedVector
  rotated_vector(const Quaternion &Q, const dealii::Tensor<1, 3> &v);
} // namespace lamella

#endif
