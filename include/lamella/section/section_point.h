// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_section_point_h
#define lamella_section_section_point_h

#include <lamella/material/elasticity.h>

#include <deal.II/base/point.h>

#include <vector>

namespace lamella
{
  /// The section functions Phi(x, z) that are nonzero at a point of a section.
  /// A displacement u = N(y) Phi has the strain N D_s Phi + N' D_y Phi (Eq. 5
  /// of Nagaraj et al. 2020), with StrainCompletion if the theory has it. Entry
  /// a of each vector belongs to section function number (*fields)[a].
  struct SectionPoint
  {
    unsigned int     cell = 0;      ///< Cell that contains the point.
    dealii::Point<2> unit;          ///< Coordinates (xi, eta) in the cell.
    dealii::Point<2> position;      ///< x, z in the body frame [length].
    double           jacobian = 0.; ///< Jacobian determinant [length^2].
    /// Indices of these section functions, ascending; owned by the Section.
    const std::vector<unsigned int> *fields = nullptr;
    /// Values Phi of the section functions [no unit].
    std::vector<dealii::Tensor<1, 3>> value;
    std::vector<Voigt> in_plane, ///< Strains D_s Phi [1 / length].
      along;                     ///< Strains D_y Phi [no unit].
    /// Rotations about y, (d Phi_x / dz - d Phi_z / dx) / 2 [1 / length].
    std::vector<double> twist;
  };

  /// Returns the strain components yy, xy, yz due to the derivative @p v of the
  /// displacement along y; the others are zero.
  Voigt
  axial_strain(const dealii::Tensor<1, 3> &v);

  /// Returns true if the strain component number @p c, from 0 in the order of
  /// Voigt, is a transverse shear strain xy or yz.
  constexpr bool
  is_transverse_shear(const unsigned int c)
  {
    return c == 3 || c == 5;
  }
} // namespace lamella

#endif
