// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_curve_normals_h
#define lamella_shape_curve_normals_h

#include <lamella/shape/section_mesh.h>

#include <array>
#include <string>
#include <vector>

namespace lamella
{
  /// The outward unit normals of boundaries of a section, extended to all
  /// points x of the section: the normal at x is that of the nearest point p on
  /// a side whose normal is parallel to x - p. Normals vary linearly along a
  /// side; at a vertex, the normals of the adjacent sides are averaged unless
  /// they differ by more than 30 degrees.
  class CurveNormals
  {
  public:
    /// Collects the sides of the boundaries @p names of @p section.
    CurveNormals(const SectionMesh              &section,
                 const std::vector<std::string> &names);

    /// Returns the outward unit normal, extended from the boundaries to the
    /// point @p x of the section. All sides are searched.
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
