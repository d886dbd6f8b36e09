// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_saint_venant_h
#define lamella_section_saint_venant_h

#include <lamella/linear/linear_solver.h>
#include <lamella/section/section.h>
#include <lamella/section/warping.h>

#include <deal.II/lac/full_matrix.h>

#include <array>
#include <memory>
#include <vector>

namespace lamella
{
  /// A 6 x 6 matrix of section forces or strains (SaintVenant::Force).
  using SectionTensor = dealii::Tensor<2, 6>;

  /**
   * The six Saint-Venant states of a section: its deformation far from ends and
   * loads under an axial force, a torque, two bending moments and two shear
   * forces. They have the full three-dimensional law, for any shape, layup and
   * coupling (central solutions: Giavotto et al., Comput. Struct. 16 (1983)
   * 403; Borri and Merlini 1986).
   *
   * A state is a pair of field vectors, the value a and the derivative b with
   * respect to y, with the strain D_s a + D_y b at y = 0:
   *   extension   S_00 a = E t_y,                   b = t_y
   *   torsion     S_00 a = E r,                     b = r
   *   curvatures  S_00 a = E b + S_11 t_x,          b = -h s_x   (and z)
   *   shear       S_00 a = E a_0 + S_11 b_0,        b = a_0,
   * with E = S_10 - S_01, the rigid fields t_x, t_y, t_z, the rotation r about
   * y, the slopes s_x, s_z (u_y = x / h, z / h) and the reference length h.
   * (a_0, b_0) is a curvature, freed of axial force and torque by extension and
   * torsion. S_00 vanishes for t_x, t_y, t_z and r, which are fixed; one
   * Cholesky factorization serves all six.
   *
   * The resultants g = S_10 a + S_11 b at the rigid fields form the columns of
   * F. F and the energies Q_ij of pairs of states give
   *   compliance  F^-T Q F^-1   and its inverse, the stiffness
   * in Timoshenko's sense, in the space of the section's own theory: use LE,
   * whose error falls with its degree.
   */
  class SaintVenant
  {
  public:
    /// Order of section forces and of their conjugate strains. Forces act on
    /// the face of outward normal +y, moments about the centroid (x_c, z_c),
    /// right-handed about body axes:
    ///   M_x = -int (z - z_c) s_yy dA, M_z = int (x - x_c) s_yy dA,
    ///   M_y = int ((z - z_c) s_xy - (x - x_c) s_yz) dA.
    enum Force : unsigned int
    {
      F_x, ///< shear force [force]; its strain is gamma_xy
      F_y, ///< axial force [force]; eps_yy
      F_z, ///< shear force [force]; gamma_yz
      M_x, ///< bending about x [force length]; kappa_x [1 / length]
      M_y, ///< torque [force length]; rate of twist [rad / length]
      M_z  ///< bending about z [force length]; kappa_z [1 / length]
    };

    /// Computes the states of @p section, which must have a rotation about y
    /// (not EBBT or TBT) and outlive the object. Throws NumericsError if S_00
    /// is not positive definite.
    explicit SaintVenant(const Section &section);

    const Section &
    of_section() const
    {
      return section;
    }

    /// Return a and b of each state in the section's fields: extension,
    /// torsion, curvature in x and in z, shear in x and z. Scaled as in the
    /// table of the class, with the amplitude of a rigid field free in each.
    const std::vector<Vector> &
    values() const
    {
      return value;
    }
    const std::vector<Vector> &
    derivatives() const
    {
      return derivative;
    }

    /// Returns section strains per section force, in the order of Force.
    const SectionTensor &
    compliance() const
    {
      return section_compliance;
    }

    /// Returns the inverse of the compliance.
    const SectionTensor &
    stiffness() const
    {
      return section_stiffness;
    }

    /// Returns the response to @p load, constant along the axis, beyond the six
    /// states: S_00 v = f + sum_j c_j (E a_j + S_11 b_j). The extension, the
    /// torsion and the two shears j balance force and torque (the first term of
    /// the solution of Almansi and Michell).
    Vector
    response_to_constant(const Vector &load) const;

    /// Returns v of S_00 v = @p load with translations and rotation about y
    /// fixed.
    Vector
    constrained_response(Vector load) const;

  private:
    /// Returns a of S_00 a = E @p v + S_11 @p w, the fixed fields zero.
    Vector
    solve(const Vector &v, const Vector &w) const;
    /// Returns E @p v + S_11 @p w.
    Vector
    right_hand_side(const Vector &v, const Vector &w) const;
    void
    find_states();
    /// Computes the shear states from the curvatures.
    void
    find_shear_states();
    /// Computes the resultants F of the states and their energies Q in pairs.
    void
    find_resultants(dealii::FullMatrix<double> &forces,
                    dealii::FullMatrix<double> &energies) const;
    void
    find_compliance();

    const Section                      &section;
    std::unique_ptr<const LinearSolver> solver;
    std::vector<Vector>                 value, derivative;
    SectionTensor                       section_compliance, section_stiffness;
  };

  /// Returns the six Saint-Venant warpings as columns: the states' values
  /// without their rigid parts (Warping), orthonormal in S_00. The theory SV
  /// has these and the rigid fields. There are fewer than six if states do not
  /// warp, or warp alike.
  FieldColumns
  saint_venant_warpings(const SaintVenant &states, const Warping &warping);

  /// Engineering constants from the 6 x 6 compliance. Each stiffness is against
  /// its own force or moment alone, with couplings free.
  struct SectionConstants
  {
    /// Axial stiffness 1 / c(F_y, F_y) about the tension center [force].
    double EA = 0.;
    /// Principal bending stiffnesses, the larger first [force length^2], and
    /// the angle of the first bending axis, from +x towards +z, in degrees.
    std::array<double, 2> EI{};
    double                angle = 0.;
    /// Torsional stiffness [force length^2].
    double GJ = 0.;
    /// Stiffness for shear forces along x and z in the shear center [force].
    double kGA_x = 0., kGA_z = 0.;
    /// Points [length] of axial forces without bending and shear without twist.
    dealii::Point<2> tension_center, shear_center;
  };

  /// Returns the constants of a section with the centroid @p center.
  SectionConstants
  section_constants(const SectionTensor    &compliance,
                    const dealii::Point<2> &center);
} // namespace lamella

#endif
