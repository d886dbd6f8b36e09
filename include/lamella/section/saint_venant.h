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
  /// A 6 x 6 matrix between section forces and section strains;
  /// SaintVenant::Force defines their order.
  using SectionTensor = dealii::Tensor<2, 6>;

  /// Computes the six Saint-Venant solutions of a section: its deformation far
  /// from ends and loads under an axial force, a torque, two bending moments
  /// and two shear forces. They are valid for any shape, layup and coupling
  /// (central solutions: Giavotto et al., Comput. Struct. 16 (1983) 403; Borri
  /// and Merlini 1986).
  ///
  /// A solution consists of the coefficients a of the section functions and
  /// their derivatives b by y at y = 0, with the strain D_s a + D_y b,
  ///   extension   S_00 a = E t_y,                   b = t_y
  ///   torsion     S_00 a = E r,                     b = r
  ///   curvatures  S_00 a = E b + S_11 t_x,          b = -h s_x   (and z)
  ///   shear       S_00 a = E a_0 + S_11 b_0,        b = a_0,
  /// with the matrices S_pq of Section, E = S_10 - S_01, the rigid translations
  /// t_x, t_y, t_z, the rotation r about y, the slopes s_x, s_z (u_y = x / h, z
  /// / h) and the reference length h. (a_0, b_0) is a curvature solution plus
  /// extension and torsion such that axial force and torque vanish. S_00 is
  /// singular for t_x, t_y, t_z and r, which are constrained. All solutions use
  /// one factorization.
  ///
  /// The stress resultants of each solution are the columns of F. With the
  /// mutual energies Q_ij of pairs of solutions, F^-T Q F^-1 is the compliance
  /// of a Timoshenko beam. Its error is that of the section's theory; use LE.
  class SaintVenant
  {
  public:
    /// Order of the section forces and their conjugate strains. Forces act on
    /// the face with outward normal +y. Moments about the centroid (x_c, z_c)
    /// follow from the stresses s_ij,
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

    /// Computes the six solutions of @p section, which must outlive this
    /// object. Not for EBBT and TBT, which cannot twist. Throws NumericsError
    /// if the constrained stiffness is not positive definite.
    explicit SaintVenant(const Section &section);

    /// Returns the section.
    const Section &
    of_section() const
    {
      return section;
    }

    /// Returns the coefficients of the section functions at y = 0 for the
    /// solutions extension, torsion, curvature in x and z, shear in x and z.
    const std::vector<Vector> &
    values() const
    {
      return value;
    }
    /// Returns the derivatives by y of the coefficients in values().
    const std::vector<Vector> &
    derivatives() const
    {
      return derivative;
    }

    /// Returns the compliance matrix: section strains per section force.
    const SectionTensor &
    compliance() const
    {
      return section_compliance;
    }

    /// Returns the stiffness matrix, the inverse of the compliance.
    const SectionTensor &
    stiffness() const
    {
      return section_stiffness;
    }

    /// Returns the warping due to a section @p load that is constant along the
    /// axis (Almansi-Michell, first term). Section forces that change along the
    /// axis balance the load: those of the extension, torsion and shear
    /// solutions.
    Vector
    response_to_constant(const Vector &load) const;

    /// Returns v with S_00 v = @p load, where the rigid translations and the
    /// rotation about y of the section are constrained to zero.
    Vector
    constrained_response(Vector load) const;

  private:
    /// Returns the constrained solution a of S_00 a = E @p v + S_11 @p w.
    Vector
    solve(const Vector &v, const Vector &w) const;
    /// Returns E @p v + S_11 @p w with E = S_10 - S_01.
    Vector
    right_hand_side(const Vector &v, const Vector &w) const;
    void
    find_states();
    /// Computes the two shear states from the curvature states.
    void
    find_shear_states();
    /// Computes the matrices F of stress resultants and Q of mutual energies.
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

  /// Returns the warping functions of the theory SV as columns: the
  /// coefficients of @p states without rigid motions (@p warping), orthonormal
  /// in S_00, without zero and linearly dependent columns.
  FieldColumns
  saint_venant_warpings(const SaintVenant &states, const Warping &warping);

  /// Engineering constants of a section, from its 6 x 6 compliance. Stiffnesses
  /// are for one force or moment each; coupled deformations are free.
  struct SectionConstants
  {
    /// Axial stiffness for forces through the tension center [force].
    double EA = 0.;
    /// Principal bending stiffnesses, the larger first [force length^2].
    std::array<double, 2> EI{};
    double angle = 0.; ///< From +x to +z, of the first axis [degrees].
    /// Torsional stiffness [force length^2].
    double GJ    = 0.;
    double kGA_x = 0., ///< Stiffness for shear forces along x [force].
      kGA_z      = 0.; ///< Stiffness for shear forces along z [force].
    dealii::Point<2> tension_center, ///< Axial forces there do not bend.
      shear_center;                  ///< Shear forces there do not twist.
  };

  /// Returns the constants from the @p compliance about the centroid @p center.
  SectionConstants
  section_constants(const SectionTensor    &compliance,
                    const dealii::Point<2> &center);

  /// Returns the strain of a fiber at @p point of a section with the twist k,
  /// divided by k^2 / 2 [length^2]: the axial strain r^2, with the distance r
  /// from the centroid, and the lateral contraction of StrainCompletion.
  Voigt
  stretch_of_fiber(const Section &section, const SectionPoint &point);

  /// The second-order axial strain of a beam due to a twist k [rad / length]:
  /// fibers at the distance r from the centroid are inclined by k r and thus
  /// elongated (Wagner effect, 1929),
  ///   epsilon_2 = k^2 / 2 (r^2 e_yy + D_s v),
  /// where e_yy is a unit strain along y, D_s v the in-plane strain of the free
  /// contraction v, and S_00 v = -int D_s^T C e_yy r^2 dA with the elasticity
  /// matrix C and the section matrix S_00. With I_n = int r^n dA and I_p = I_2,
  /// this effect adds E (I_4 - I_p^2 / A) k^2 / 2 to the stiffness G J of a
  /// strip. It reduces G J of a column under the compression N by N I_p / A.
  /// Only for LE with a fine mesh. On one cell of LE-2, I_4 - I_p^2 / A is 19 %
  /// too large in a bar of 8 x 5 and 7 % in a strip of 30 x 0.8.
  class TwistStretch
  {
  public:
    /// Computes the strain from the Saint-Venant solutions of a section.
    explicit TwistStretch(const SaintVenant &states);

    /// Returns the second-order strain at @p point for k^2 / 2 = 1 [length^2].
    Voigt
    strain(const SectionPoint &point) const;

    /// Returns the generalized forces of the second-order strain for k^2 / 2 =
    /// 1 [force length^2], conjugate to the axial derivatives of amplitudes of
    /// section functions. The forces conjugate to the amplitudes are zero.
    const std::vector<double> &
    work() const
    {
      return on_derivatives;
    }

    /// Returns int e . C e dA of the second-order strain e at k^2 / 2 = 1
    /// [force length^4], with the elasticity matrix C.
    double
    stiffness() const
    {
      return square;
    }

    /// Returns the coefficient c [length^2] of the torque M = G J k (1 + c k^2)
    /// due to the second-order strain, for a beam that is free to stretch.
    double
    stiffening() const
    {
      return c;
    }

  private:
    double
    stiffening_of(const SaintVenant &states) const;

    const Section      &section;
    Vector              relaxation;
    std::vector<double> on_derivatives;
    double              square = 0., c = 0.;
  };
} // namespace lamella

#endif
