// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_section_point_h
#define lamella_section_section_point_h

#include <lamella/material/elasticity.h>

#include <deal.II/base/point.h>

#include <vector>

namespace lamella
{
  /// The nonzero fields at a point of the section with their strains (order of
  /// Eq. 4). The strain of u = N(y) Phi(x, z) is N in_plane + N' along, that is
  /// N D_s Phi + N' D_y Phi of Eq. 5, completed by the theory
  /// (StrainCompletion). Entry a of each vector belongs to the field
  /// (*fields)[a].
  struct SectionPoint
  {
    /// Cell, and place on its unit square.
    unsigned int     cell = 0;
    dealii::Point<2> unit;
    /// Position x, z in the body frame [length], and det(d(x, z) / d(xi, eta)).
    dealii::Point<2> position;
    double           jacobian = 0.;
    /// Field numbers, ascending; owned by the Section.
    const std::vector<unsigned int> *fields = nullptr;
    /// Phi_alpha: u of a unit of the field [no unit].
    std::vector<dealii::Tensor<1, 3>> value;
    /// D_s Phi [1 / length] and D_y Phi [no unit], engineering shear strains.
    std::vector<Voigt> in_plane, along;
    /// Rotation about the axis, (d Phi_x / dz - d Phi_z / dx) / 2 [1 / length].
    std::vector<double> twist;
  };

  /// Returns D_y Phi of Eq. 5: the strain {0, v_y, 0, v_x, 0, v_z} of an axial
  /// derivative @p v of the displacement, in the order of Eq. 4.
  Voigt
  axial_strain(const dealii::Tensor<1, 3> &v);

  /// Returns true if strain number @p c, from 0 in the order of Eq. 4, is a
  /// transverse shear strain xy or yz.
  constexpr bool
  is_transverse_shear(const unsigned int c)
  {
    return c == 3 || c == 5;
  }
} // namespace lamella

#endif
