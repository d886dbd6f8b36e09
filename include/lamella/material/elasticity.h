// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_material_elasticity_h
#define lamella_material_elasticity_h

#include <deal.II/base/tensor.h>

#include <string>

namespace lamella
{
  /**
   * A symmetric second-order tensor in the order of the paper's Eq. 4, {xx, yy,
   * zz, xy, xz, yz}. Strains carry the engineering shear strains gamma = 2
   * epsilon in the last three places, so that sigma . epsilon is twice the
   * density of the strain energy. Stresses carry the plain shear stresses.
   * Index 0 to 5 in that order, in whatever axes the context says: scene, body
   * (x across, y along, z up) or ply (11, 22, 33, 12, 13, 23).
   */
  using Voigt = dealii::Tensor<1, 6>;

  /// C of sigma = C epsilon (Eq. 6) in that order. Row i, column j in the order
  /// of Voigt; symmetric; [force/length^2]. Because of the engineering shear
  /// strains a shear modulus stands on the diagonal as it is, without a factor
  /// 2.
  using ElasticTensor = dealii::Tensor<2, 6>;

  /// Three unit vectors e_1, e_2, e_3 as the rows of a matrix. Orthonormal and
  /// right-handed, given in the frame that it is used in: row k is e_k, so
  /// triad * v are the components of v along its axes.
  using Triad = dealii::Tensor<2, 3>;

  /// The axes themselves. The identity: it takes components into themselves.
  Triad
  unit_triad();

  /**
   * The nine constants of an orthotropic material in its own axes: 1 along the
   * fibre, 2 across it in the plane of the ply, 3 normal to the ply. Stresses
   * in the units of the scene. nu_ij is the contraction along j under a tension
   * along i, so nu_ij / E_i = nu_ji / E_j. The other three ratios follow: nu_21
   * = nu_12 E_2 / E_1, and so on. All are zero, and so no material, until set.
   */
  struct EngineeringConstants
  {
    /// Young's moduli along 1, 2 and 3 [force/length^2].
    double E1 = 0., E2 = 0., E3 = 0.;
    /// Shear moduli in the planes 12, 13 and 23 [force/length^2].
    double G12 = 0., G13 = 0., G23 = 0.;
    /// Poisson's ratios, pure numbers.
    double nu12 = 0., nu13 = 0., nu23 = 0.;

    /// The isotropic material of Young's modulus @p E and Poisson's ratio
    /// @p nu. With G = E / (2 (1 + nu)) in all planes. Nothing is checked:
    /// violated_condition() tells whether it is a material, -1 < nu < 1/2.
    static EngineeringConstants
    isotropic(const double E, const double nu);

    /**
     * The first condition of positive definiteness that the constants violate,
     * in words, or nothing. The conditions (Lempriere 1968): all moduli
     * positive, nu_ij^2 < E_i / E_j for each pair, and 1 - nu12 nu21 - nu23
     * nu32 - nu13 nu31 - 2 nu21 nu32 nu13 > 0. For messages, with the values; a
     * value that is no number violates them, too. Together they are the
     * positive definiteness of the compliance, hence of C and of the energy.
     */
    std::string
    violated_condition() const;

    /**
     * C in the material's own axes, in the order {11, 22, 33, 12, 13, 23}: the
     * inverse of the compliance with entries 1/E_i, -nu_ij/E_i and 1/G_ij. The
     * constants must be positive definite. The 3 x 3 block of the normal
     * components is the inverse of
     *   [ 1/E1     -nu12/E1  -nu13/E1 ]
     *   [ -nu12/E1  1/E2     -nu23/E2 ]
     *   [ -nu13/E1 -nu23/E2   1/E3    ],
     * made symmetric to the last bit; G12, G13, G23 follow on the diagonal, and
     * nothing couples shear.
     */
    ElasticTensor
    stiffness() const;
  };

  /**
   * The matrix T that takes strains (with engineering shear strains) into the
   * axes of @p triad: epsilon' = T epsilon. By invariance of the energy, sigma
   * = T^T sigma' and C = T^T C' T.
   *
   * With epsilon'_kl = e_k . epsilon e_l, the rows of T are products of
   * components of e_k and e_l; those of shears count both places of the
   * symmetric tensor. T is not orthogonal, because of the engineering shear
   * strains: T^T is not its inverse, and stresses turn with T^-T.
   */
  ElasticTensor
  strain_rotation(const Triad &triad);

  /// C in the frame that @p triad is given in, from @p local in the triad's
  /// own. T^T C' T with the T of strain_rotation(): from ply axes into the
  /// body's, if the triad is ply_axes().
  ElasticTensor
  rotated(const ElasticTensor &local, const Triad &triad);

  /**
   * The ply axes in the body frame (x across, y along, z up) for a fibre at
   * @p degrees, 0 along +y and positive from +y towards +x: e_1 = (sin, cos,
   * 0), e_3 = (0, 0, 1), e_2 = e_3 x e_1 = (-cos, sin, 0).
   *
   * A rotation about z alone: fibres lie in the plane of the ply. Sine and
   * cosine below 1e-15 are set to zero, so that a ply at 90 degrees has exact
   * zeros where a cross-ply does not couple, and the stiffness matrix fewer
   * entries.
   */
  Triad
  ply_axes(const double degrees);

  /**
   * The ply axes in the body frame of a ply in the plane of y and t = y x n,
   * where the unit vector n, the ply's normal, lies in the section:
   * @p normal = (n_x, n_z), so that t = (n_z, 0, -n_x). The fibre is at
   * @p degrees, 0 along +y and positive from +y towards t,
   *   e_1 = sin t + cos y,  e_3 = n,  e_2 = e_3 x e_1 = -cos t + sin y.
   *
   * Whoever looks at the ply against n, with +y pointing up, sees positive
   * angles lean to the right. With n = +z t is +x: the axes above.
   */
  Triad
  ply_axes(const double degrees, const dealii::Tensor<1, 2> &normal);
} // namespace lamella

#endif
