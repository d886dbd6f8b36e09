// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_section_point_h
#define lamella_section_section_point_h

#include <lamella/material/elasticity.h>

#include <deal.II/base/point.h>

#include <vector>

namespace lamella
{
  /// The section functions Phi that are nonzero at a point of a section, with
  /// their strains. The strain of u = N(y) Phi(x, z) is N in_plane + N' along,
  /// i.e. N D_s Phi + N' D_y Phi (Eq. 5), with StrainCompletion if the theory
  /// has one. Entry a of each vector belongs to function (*fields)[a].
  struct SectionPoint
  {
    /// Cell that contains the point, and reference coordinates in the cell.
    unsigned int     cell = 0;
    dealii::Point<2> unit;
    /// Position x, z in the body frame [length], and Jacobian determinant.
    dealii::Point<2> position;
    double           jacobian = 0.;
    /// Numbers of the section functions, ascending; owned by the Section.
    const std::vector<unsigned int> *fields = nullptr;
    /// Values Phi of the section functions [no unit].
    std::vector<dealii::Tensor<1, 3>> value;
    /// Strains D_s Phi [1 / length] and D_y Phi [no unit].
    std::vector<Voigt> in_plane, along;
    /// Rotations about y, (d Phi_x / dz - d Phi_z / dx) / 2 [1 / length].
    std::vector<double> twist;
  };

  /// Returns the strain {0, v_y, 0, v_x, 0, v_z} (order of Voigt) due to the
  /// derivative @p v = du/dy of the displacement along the axis.
  Voigt
  axial_strain(const dealii::Tensor<1, 3> &v);

  /// Returns whether the strain component @p c, from 0 in the order of Voigt,
  /// is a transverse shear strain xy or yz.
  constexpr bool
  is_transverse_shear(const unsigned int c)
  {
    return c == 3 || c == 5;
  }
} // namespace lamella

#endif
