// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_material_elasticity_h
#define lamella_material_elasticity_h

#include <deal.II/base/tensor.h>

#include <string>

namespace lamella
{
  /// A stress or strain with the components {xx, yy, zz, xy, xz, yz} in scene
  /// or body axes (x across, y along the beam, z up), or {11, 22, 33, 12, 13,
  /// 23} in ply axes. Shear strains are gamma = 2 epsilon.
  using Voigt = dealii::Tensor<1, 6>;

  /// The symmetric 6 x 6 stiffness matrix C of Hooke's law sigma = C epsilon in
  /// the order of Voigt [force/length^2].
  using ElasticTensor = dealii::Tensor<2, 6>;

  /// Orthonormal, right-handed vectors e_1, e_2, e_3 as the rows of a matrix.
  using Triad = dealii::Tensor<2, 3>;

  /// Returns the triad of the coordinate axes, the identity matrix.
  Triad
  unit_triad();

  /// The nine elastic constants of an orthotropic material in its material
  /// axes: 1 along the fiber, 2 across the fiber in the plane of the ply, 3
  /// normal to the ply. nu_ij is the contraction along j under tension along i:
  /// nu_ij / E_i = nu_ji / E_j. The default values of zero are invalid.
  struct EngineeringConstants
  {
    double E1   = 0., ///< Young's modulus along 1, the fiber [force/length^2].
      E2        = 0., ///< Young's modulus along 2 [force/length^2].
      E3        = 0.; ///< Young's modulus along 3 [force/length^2].
    double G12  = 0., ///< Shear modulus in the plane 12 [force/length^2].
      G13       = 0., ///< Shear modulus in the plane 13 [force/length^2].
      G23       = 0.; ///< Shear modulus in the plane 23 [force/length^2].
    double nu12 = 0., ///< Poisson's ratio, contraction along 2 by tension in 1.
      nu13      = 0., ///< Poisson's ratio, contraction along 3 by tension in 1.
      nu23      = 0.; ///< Poisson's ratio, contraction along 3 by tension in 2.

    /// Returns the constants of an isotropic material with Young's modulus @p E
    /// and Poisson's ratio @p nu, G = E / (2 (1 + nu)), without checks.
    static EngineeringConstants
    isotropic(const double E, const double nu);

    /// Returns a description of the first violated condition for a positive
    /// definite compliance; empty if all hold. The conditions (Lempriere 1968)
    /// are: all moduli positive, nu_ij^2 < E_i / E_j for each pair, and 1 -
    /// nu12 nu21 - nu23 nu32 - nu13 nu31 - 2 nu21 nu32 nu13 > 0.
    std::string
    violated_condition() const;

    /// Returns the stiffness matrix C in the material's own axes, in the order
    /// {11, 22, 33, 12, 13, 23}. violated_condition() must be empty. The 3 x 3
    /// block of the normal components is the inverse of
    ///   [ 1/E1     -nu12/E1  -nu13/E1 ]
    ///   [ -nu12/E1  1/E2     -nu23/E2 ]
    ///   [ -nu13/E1 -nu23/E2   1/E3    ],
    /// made exactly symmetric. The other diagonal entries are G12, G13, G23.
    ElasticTensor
    stiffness() const;
  };

  /// Returns the matrix T that transforms strains in the order of Voigt into
  /// the axes of @p triad: epsilon' = T epsilon. Since the energy is invariant,
  /// sigma = T^T sigma' and C = T^T C' T. T is not orthogonal.
  ElasticTensor
  strain_rotation(const Triad &triad);

  /// Returns the stiffness C = T^T C' T in the frame in which the vectors of
  /// @p triad are given, e.g. the body frame, from the stiffness @p local C' in
  /// the axes of @p triad, e.g. ply_axes(). T is strain_rotation().
  ElasticTensor
  rotated(const ElasticTensor &local, const Triad &triad);

  /// Returns the ply axes in the body frame (x across, y along, z up) for a
  /// fiber at @p degrees, 0 along +y and positive towards +x: e_1 = (sin, cos,
  /// 0), e_3 = (0, 0, 1), e_2 = e_3 x e_1 = (-cos, sin, 0). Sines and cosines
  /// below 1e-15 are set to zero, which is exact for cross-plies.
  Triad
  ply_axes(const double degrees);

  /// Returns the ply axes in the body frame of a ply with the unit @p normal n
  /// = (n_x, n_z) in the section. Its plane is spanned by y and t = y x n =
  /// (n_z, 0, -n_x). @p degrees is the fiber angle from +y towards t,
  ///   e_1 = sin t + cos y,  e_3 = n,  e_2 = e_3 x e_1 = -cos t + sin y.
  /// For n = +z, t is +x, and the result is ply_axes(degrees).
  Triad
  ply_axes(const double degrees, const dealii::Tensor<1, 2> &normal);
} // namespace lamella

#endif
