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
  /// A 6 x 6 matrix for section forces or strains, see SaintVenant::Force.
  using SectionTensor = dealii::Tensor<2, 6>;

  /// The six Saint-Venant solutions (states) of a section: its deformation far
  /// from ends and loads under an axial force, a torque, two bending moments
  /// and two shear forces, with the three-dimensional constitutive law, for any
  /// shape, layup and coupling (central solutions: Giavotto et al., Comput.
  /// Struct. 16 (1983) 403; Borri and Merlini 1986).
  ///
  /// A state consists of the coefficients a of the section functions and their
  /// derivatives b by y at y = 0, with the strain D_s a + D_y b,
  ///   extension   S_00 a = E t_y,                   b = t_y
  ///   torsion     S_00 a = E r,                     b = r
  ///   curvatures  S_00 a = E b + S_11 t_x,          b = -h s_x   (and z)
  ///   shear       S_00 a = E a_0 + S_11 b_0,        b = a_0,
  /// with the matrices S_pq of Section, E = S_10 - S_01, the rigid translations
  /// t_x, t_y, t_z, the rotation r about y, the slopes s_x, s_z (u_y = x / h, z
  /// / h) and the reference length h. (a_0, b_0) is a curvature, to which
  /// extension and torsion are added so that axial force and torque are zero.
  /// S_00 is singular for t_x, t_y, t_z and r, which are constrained. All
  /// states use one factorization.
  ///
  /// The stress resultants of each state, S_10 a + S_11 b for the rigid
  /// functions, are the columns of F. With the mutual energies Q_ij of pairs of
  /// states, the result is the
  ///   compliance  F^-T Q F^-1   and its inverse, the stiffness
  /// of a Timoshenko beam. The error is that of the section's theory; use LE.
  class SaintVenant
  {
  public:
    /// Order of the section forces and their conjugate strains. Forces act on
    /// the face with outward normal +y. Moments are about the centroid (x_c,
    /// z_c), right-handed about the body axes, with stresses s_ij:
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

    /// Computes the states of @p section, which must outlive this object. Not
    /// for EBBT and TBT, which cannot twist. Throws NumericsError if the
    /// constrained S_00 is not positive definite.
    explicit SaintVenant(const Section &section);

    const Section &
    of_section() const
    {
      return section;
    }

    /// Return the coefficients a and b of the states: extension, torsion,
    /// curvature in x and z, shear in x and z, scaled as described above.
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

    /// Returns the section stiffness, the inverse of the compliance.
    const SectionTensor &
    stiffness() const
    {
      return section_stiffness;
    }

    /// Returns the warping v due to a section @p load f that is constant along
    /// the axis (first term of the Almansi-Michell solution), S_00 v = f +
    /// sum_j c_j (E a_j + S_11 b_j). The factors c_j of the extension, torsion
    /// and shear states j are such that their resultants balance f.
    Vector
    response_to_constant(const Vector &load) const;

    /// Returns the solution v of S_00 v = @p load with translations and the
    /// rotation about y constrained to zero.
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

  /// Returns the Saint-Venant warping functions of the theory SV as columns:
  /// the coefficients a of the states minus rigid motions (Warping),
  /// orthonormal in S_00, without zero and linearly dependent columns.
  FieldColumns
  saint_venant_warpings(const SaintVenant &states, const Warping &warping);

  /// Engineering constants from the 6 x 6 compliance of a section. Each
  /// stiffness is for a single force or moment, with coupled deformations free.
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
    /// Points where axial forces do not bend and shear forces do not twist.
    dealii::Point<2> tension_center, shear_center;
  };

  /// Returns the constants from the @p compliance about the centroid @p center.
  SectionConstants
  section_constants(const SectionTensor    &compliance,
                    const dealii::Point<2> &center);
} // namespace lamella

#endif
