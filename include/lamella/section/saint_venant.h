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
  /// A 6 x 6 matrix of section forces or strains, see SaintVenant::Force.
  using SectionTensor = dealii::Tensor<2, 6>;

  /**
   * The six Saint-Venant states of a section: how it deforms far from its ends
   * and from whatever loads it, under an axial force, a torque, two bending
   * moments and two shear forces, for any shape, layup and coupling, with the
   * full three-dimensional law (the central solutions: Giavotto et al., Comput.
   * Struct. 16 (1983) 403; Borri and Merlini 1986).
   *
   * A state is a pair of field vectors, the value a and the derivative b with
   * respect to y, with the strain D_s a + D_y b at y = 0. With E = S_10 - S_01,
   * the rigid fields t_x, t_y, t_z, the rotation r about y, the slopes s_x, s_z
   * (u_y = x / h, z / h) and h the reference length:
   *   extension   S_00 a = E t_y,                   b = t_y
   *   torsion     S_00 a = E r,                     b = r
   *   curvatures  S_00 a = E b + S_11 t_x,          b = -h s_x   (and z)
   *   shear       S_00 a = E a_0 + S_11 b_0,        b = a_0,
   * where (a_0, b_0) is a curvature with as much of extension and torsion as
   * frees it of axial force and torque. S_00 vanishes for t_x, t_y, t_z and r,
   * which are held; one Cholesky factorisation serves all six.
   *
   * The resultants of a state are g = S_10 a + S_11 b at the rigid fields; from
   * them, the columns of F, and the energies Q_ij of pairs of states follow
   *   compliance  F^-T Q F^-1   and its inverse, the stiffness
   * in Timoshenko's sense. In the space of the section's own theory: use one of
   * LE, whose error falls with its degree.
   */
  class SaintVenant
  {
  public:
    /// The order of section forces, and of the strains that do work on them.
    /// Forces act on the face whose outward normal is +y, moments about the
    /// centre of area (x_c, z_c), right-handed about the body's axes:
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

    /// Throws NumericsError if S_00 without the four fields is not positive
    /// definite in doubles. @p section must have a field for the rotation about
    /// y, so not EBBT or TBT, and live longer.
    explicit SaintVenant(const Section &section);

    const Section &
    of_section() const
    {
      return section;
    }

    /// The value a and the derivative b of each state at y = 0 in the section's
    /// fields: extension, torsion, curvature in x and in z, shear in x and z.
    /// Scaled as above, a whole rigid field free in each.
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

    /// Section strains per section force, in the order of Force.
    const SectionTensor &
    compliance() const
    {
      return section_compliance;
    }

    /// Its inverse.
    const SectionTensor &
    stiffness() const
    {
      return section_stiffness;
    }

    /**
     * How the section deforms under the load @p load that is constant along the
     * axis, apart from what the six states say: with the states' part taken off
     * that balances it, S_00 v = f + sum_j c_j (E a_j + S_11 b_j), j the
     * extension, the torsion and the two shears, so that no force or torque is
     * left over (the first term of the solution of Almansi and Michell).
     */
    Vector
    response_to_constant(const Vector &load) const;

    /// S_00 v = @p load with translations and the turn about y held, whatever
    /// the load does on these.
    Vector
    held_response(Vector load) const;

  private:
    /// S_00 a = E @p v + S_11 @p w, the held fields zero.
    Vector
    solve(const Vector &v, const Vector &w) const;
    /// E @p v + S_11 @p w.
    Vector
    right_hand_side(const Vector &v, const Vector &w) const;
    void
    find_states();
    /// After the curvatures have been found.
    void
    find_shear_states();
    /// F, the resultants of the states, and Q, their energies in pairs.
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

  /**
   * The six Saint-Venant warpings as columns, made of the states' values:
   * without their rigid parts (Warping) and orthonormal in S_00. With the six
   * rigid fields they are the fields of the theory SV: each with an amplitude
   * of its own, so that the section may bend without contracting next to a
   * clamp, say. Fewer than six where states do not warp, or warp alike.
   */
  FieldColumns
  saint_venant_warpings(const SaintVenant &states, const Warping &warping);

  /// What an engineer reads off the 6 x 6 compliance. Each stiffness is that
  /// against its own force or moment alone, all other section forces being zero
  /// and the section free to couple.
  struct SectionConstants
  {
    /// 1 / c(F_y, F_y) about the tension centre [force].
    double EA = 0.;
    /// Principal bending stiffnesses, the larger first [force length^2], and
    /// the angle from +x towards +z of the axis that the first bends about, in
    /// degrees from -90 to 90.
    std::array<double, 2> EI{};
    double                angle = 0.;
    /// Torsion [force length^2].
    double GJ = 0.;
    /// Against shear forces along x and z through the shear centre [force].
    double kGA_x = 0., kGA_z = 0.;
    /// Where an axial force does not bend, and a shear force does not twist the
    /// section: section coordinates [length].
    dealii::Point<2> tension_centre, shear_centre;
  };

  /// Of a section with the centre of area @p centre.
  SectionConstants
  section_constants(const SectionTensor    &compliance,
                    const dealii::Point<2> &centre);
} // namespace lamella

#endif
