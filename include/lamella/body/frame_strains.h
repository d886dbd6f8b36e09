// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_frame_strains_h
#define lamella_body_frame_strains_h

#include <deal.II/base/tensor.h>

#include <array>

namespace lamella
{
  // The kinematics of a section that turns by any angle and keeps its shape but
  // for warping (Reissner, Simo): what R, the rotation of the section, and the
  // place r of its centre say of strains and places, in the axes of the body.
  // R is that of a quaternion Q = (Q_0, Q_x, Q_y, Q_z) of any length,
  //   R v = Q (0, v) Q* / |Q|^2,
  // as it is where unit quaternions of nodes are interpolated: what follows
  // does not depend on |Q|, to the last derivative, and is the same in a scene
  // that turns as a whole.

  using Quaternion = dealii::Tensor<1, 4>;

  /// exp(theta / 2): the rotation by |theta| about @p theta [rad].
  Quaternion
  quaternion_of(const dealii::Tensor<1, 3> &theta);

  /// The rotation vector of @p q, its angle 0 to pi [rad].
  dealii::Tensor<1, 3>
  rotation_vector_of(const Quaternion &q);

  /// The rotation @p b and then @p a.
  Quaternion
  turned_by(const Quaternion &a, const Quaternion &b);

  /// dq / d theta of a spin theta after the rotation @p q, dq = (0, theta) q /
  /// 2, a row a component of q.
  std::array<dealii::Tensor<1, 3>, 4>
  spin_derivative(const Quaternion &q);

  /// R(Q).
  dealii::Tensor<2, 3>
  rotation_of(const Quaternion &Q);

  /// Some functions f_k of n numbers with their first and second derivatives.
  template <unsigned int n_functions, int n>
  struct Derivatives
  {
    std::array<double, n_functions>               value{};
    std::array<dealii::Tensor<1, n>, n_functions> first;
    std::array<dealii::Tensor<2, n>, n_functions> second;
  };

  /**
   * The strains of a section about its axis y at the rotation @p Q, with the
   * derivatives @p dQ and @p dr along y of that and of the displacement of its
   * centre:
   *   Gamma = R^T (e_y + r') - e_y,
   *   kappa = vec(R^T R') = 2 vec(Q* Q') / |Q|^2,
   * Gamma_x, Gamma_z the shears [no unit], kappa_x and kappa_z the curvatures
   * and kappa_y the twist [1 / length]; and as their seventh kappa_y^2 / 2. In
   * the place of Gamma_y, kappa_x and kappa_z are
   *   Gamma_y + (Gamma_x^2 + Gamma_z^2) / 2,
   *   kappa_x - kappa_y Gamma_x,   kappa_z - kappa_y Gamma_z:
   * with r^2 times the seventh that is how fibres along the axis are stretched
   * that shear and twist tilt against the section's normal,
   *   [(Gamma_x + kappa_y z)^2 + (Gamma_z - kappa_y x)^2] / 2,
   * little where the section has one stiffness and is not thin, but it is what
   * stretches the faces of a sandwich whose core shears, bends it where it
   * twists, and stiffens a twisted strip. As functions of (Q, Q', r'), in this
   * order. Nothing cancels where the section does not turn much.
   */
  using FrameStrains = Derivatives<7, 11>;
  FrameStrains
  frame_strains(const Quaternion           &Q,
                const Quaternion           &dQ,
                const dealii::Tensor<1, 3> &dr);

  /// R(@p Q) @p v as a function of (Q, v).
  using TurnedVector = Derivatives<3, 7>;
  TurnedVector
  turned_vector(const Quaternion &Q, const dealii::Tensor<1, 3> &v);
} // namespace lamella

#endif
