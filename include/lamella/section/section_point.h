// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_section_point_h
#define lamella_section_section_point_h

#include <lamella/material/elasticity.h>

#include <deal.II/base/point.h>

#include <vector>

namespace lamella
{
  /**
   * The fields that do not vanish at a point of the section, with their
   * strains (order of Eq. 4): for u = N(y) Phi(x, z) the strain is
   * N in_plane + N' along, which is N D_s Phi + N' D_y Phi of Eq. 5, completed
   * as the theory demands (StrainCompletion).
   *
   * The vectors are parallel: entry a belongs to the field (*fields)[a]. A
   * beam's strain at (x, y, z) is their sum over a with q_alpha(y) and
   * q_alpha'(y) in the places of N and N'.
   */
  struct SectionPoint
  {
    /// The place, on the unit square of the cell.
    unsigned int     cell = 0;
    dealii::Point<2> unit;
    /// x and z in the body frame [length], and d(x, z) / d(xi, eta), its
    /// determinant.
    dealii::Point<2> position;
    double           jacobian = 0.;
    /// Numbers of the fields, ascending; belongs to the Section, which lives
    /// longer.
    const std::vector<unsigned int> *fields = nullptr;
    /// Phi_alpha: u of a unit of the field. No unit.
    std::vector<dealii::Tensor<1, 3>> value;
    /// D_s Phi [1 / length] and D_y Phi [no unit], engineering shear strains.
    std::vector<Voigt> in_plane, along;
    /// (d Phi_x / dz - d Phi_z / dx) / 2, the rotation about the axis. In rad a
    /// unit of the field [1 / length].
    std::vector<double> twist;
  };

  /// D_y Phi of Eq. 5: the strain {0, v_y, 0, v_x, 0, v_z} that a derivative
  /// @p v of the displacement along the axis makes. In the order of Eq. 4: xx,
  /// yy, zz, xy, xz, yz.
  Voigt
  axial_strain(const dealii::Tensor<1, 3> &v);

  /// Whether the strain number @p c is one of the transverse shear strains xy
  /// and yz, which couple the rotation of a section with the slope of the axis.
  /// @p c in the order of Eq. 4, from 0.
  constexpr bool
  is_transverse_shear(const unsigned int c)
  {
    return c == 3 || c == 5;
  }
} // namespace lamella

#endif
