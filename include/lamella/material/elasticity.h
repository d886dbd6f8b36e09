// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_material_elasticity_h
#define lamella_material_elasticity_h

#include <deal.II/base/tensor.h>

#include <string>

namespace lamella
{
  /**
   * A symmetric second-order tensor in the order of the paper's Eq. 4,
   * {xx, yy, zz, xy, xz, yz}. Strains carry the engineering shear strains
   * gamma = 2 epsilon in the last three places, so that sigma . epsilon is
   * twice the density of the strain energy.
   */
  using Voigt = dealii::Tensor<1, 6>;

  /// C of sigma = C epsilon (Eq. 6) in that order.
  using ElasticTensor = dealii::Tensor<2, 6>;

  /// Three unit vectors e_1, e_2, e_3 as the rows of a matrix.
  using Triad = dealii::Tensor<2, 3>;

  /// The axes themselves.
  Triad
  unit_triad();

  /**
   * The nine constants of an orthotropic material in its own axes: 1 along the
   * fibre, 2 across it in the plane of the ply, 3 normal to the ply. Stresses
   * in the units of the scene. nu_ij is the contraction along j under a tension
   * along i, so nu_ij / E_i = nu_ji / E_j.
   */
  struct EngineeringConstants
  {
    double E1 = 0., E2 = 0., E3 = 0.;
    double G12 = 0., G13 = 0., G23 = 0.;
    double nu12 = 0., nu13 = 0., nu23 = 0.;

    /// The isotropic material of Young's modulus @p E and Poisson's ratio @p
    /// nu.
    static EngineeringConstants
    isotropic(const double E, const double nu);

    /**
     * The first condition of positive definiteness that the constants violate,
     * in words, or nothing. The conditions (Lempriere 1968): all moduli
     * positive, nu_ij^2 < E_i / E_j for each pair, and
     * 1 - nu12 nu21 - nu23 nu32 - nu13 nu31 - 2 nu21 nu32 nu13 > 0.
     */
    std::string
    violated_condition() const;

    /**
     * C in the material's own axes, in the order {11, 22, 33, 12, 13, 23}: the
     * inverse of the compliance with entries 1/E_i, -nu_ij/E_i and 1/G_ij.
     * The constants must be positive definite.
     */
    ElasticTensor
    stiffness() const;
  };

  /**
   * The matrix T that takes strains (with engineering shear strains) into the
   * axes of @p triad: epsilon' = T epsilon. By invariance of the energy,
   * sigma = T^T sigma' and C = T^T C' T.
   */
  ElasticTensor
  strain_rotation(const Triad &triad);

  /// C in the frame that @p triad is given in, from @p local in the triad's
  /// own.
  ElasticTensor
  rotated(const ElasticTensor &local, const Triad &triad);

  /**
   * The ply axes in the body frame (x across, y along, z up) for a fibre at
   * @p degrees, 0 along +y and positive from +y towards +x:
   * e_1 = (sin, cos, 0), e_3 = (0, 0, 1), e_2 = e_3 x e_1 = (-cos, sin, 0).
   */
  Triad
  ply_axes(const double degrees);
} // namespace lamella

#endif
