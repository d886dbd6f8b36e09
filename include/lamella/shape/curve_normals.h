// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_curve_normals_h
#define lamella_shape_curve_normals_h

#include <lamella/shape/section_mesh.h>

#include <array>
#include <string>
#include <vector>

namespace lamella
{
  /// Outward normals of boundaries of a section, extended to all points by
  /// projection onto the nearest side. Normals vary linearly along a side
  /// between the means with its neighbors; x - projection is parallel to them.
  /// Sides that meet at more than 30 degrees keep their own normals.
  class CurveNormals
  {
  public:
    /// Collects the sides of the existing boundaries @p names of @p section.
    CurveNormals(const SectionMesh              &section,
                 const std::vector<std::string> &names);

    /// Returns the unit normal (n_x, n_z). Costs a loop over all sides.
    dealii::Tensor<1, 2>
    at(const dealii::Point<2> &x) const;

  private:
    struct Side
    {
      std::array<dealii::Point<2>, 2>     ends;
      std::array<dealii::Tensor<1, 2>, 2> normals;
    };
    std::vector<Side> sides;
  };
} // namespace lamella

#endif
