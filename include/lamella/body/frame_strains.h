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

  /// Rotation as quaternion (Q_0, Q_x, Q_y, Q_z), not always of unit length.
  using Quaternion = dealii::Tensor<1, 4>;

  /// Returns the unit quaternion of the rotation vector @p theta [rad].
  Quaternion
  quaternion_of(const dealii::Tensor<1, 3> &theta);

  /// Returns the rotation vector of @p q, with an angle from 0 to pi [rad].
  dealii::Tensor<1, 3>
  rotation_vector_of(const Quaternion &q);

  /// Returns the quaternion product a b: the rotation @p b, followed by @p a.
  Quaternion
  compose_rotations(const Quaternion &a, const Quaternion &b);

  /// Returns the derivative of the quaternion @p q by an infinitesimal rotation
  /// theta (spin) after it: dq = (0, theta) q / 2.
  std::array<dealii::Tensor<1, 3>, 4>
  spin_derivative(const Quaternion &q);

  /// Returns the rotation matrix of the quaternion @p Q of any length.
  dealii::Tensor<2, 3>
  rotation_of(const Quaternion &Q);

  /// Values and derivatives of functions of the n variables x_i at one point.
  template <unsigned int n_functions, int n>
  struct Derivatives
  {
    std::array<double, n_functions>               value{}; ///< Functions f_k.
    std::array<dealii::Tensor<1, n>, n_functions> first;   ///< df_k/dx_i.
    std::array<dealii::Tensor<2, n>, n_functions> second;  ///< d2f_k/dx_i dx_j.
  };

  /// Strains of a rigid beam section (axis y) with the rotation R and the
  /// displacement r, with derivatives by the quaternion Q of R, by Q' and r'
  /// along y. From
  ///   Gamma = R^T (e_y + r') - e_y,
  ///   kappa = vec(R^T R') = 2 vec(Q* Q') / |Q|^2,
  /// the strains are shears Gamma_x, Gamma_z, twist kappa_y [1 / length], and
  ///   Gamma_y + (Gamma_x^2 + Gamma_z^2) / 2,   kappa_y^2 / 2,
  ///   kappa_x - kappa_y Gamma_x,   kappa_z - kappa_y Gamma_z.
  /// The axial strain of a fiber at x, z includes (x^2 + z^2) kappa_y^2 / 2.
  /// The quadratic terms give the stretch of fibers inclined by shear and
  /// twist,
  ///   [(Gamma_x + kappa_y z)^2 + (Gamma_z - kappa_y x)^2] / 2,
  /// which matters for sandwiches with a soft core and for twisted strips.
  using FrameStrains = Derivatives<7, 11>;
  /// Returns the strains for the rotation @p Q, its derivative @p dQ along y,
  /// and the derivative @p dr of the displacement of the section's center, with
  /// derivatives up to @p order (0 to 2); those above are undefined.
  FrameStrains
  frame_strains(const Quaternion           &Q,
                const Quaternion           &dQ,
                const dealii::Tensor<1, 3> &dr,
                const unsigned int          order = 2);

  /// A rotated vector R(Q) v with its derivatives by the quaternion Q and v.
  using RotatedVector = Derivatives<3, 7>;
  /// Returns the vector @p v rotated by the quaternion @p Q, with derivatives.
  RotatedVector
  rotated_vector(const Quaternion &Q, const dealii::Tensor<1, 3> &v);
} // namespace lamella

#endif
