// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_curve_normals_h
#define lamella_shape_curve_normals_h

#include <lamella/shape/section_mesh.h>

#include <array>
#include <string>
#include <vector>

namespace lamella
{
  /// The outward unit normals n of some boundaries of a section, extended to
  /// all points x of the section: n(x) = n(p) at the nearest boundary point p
  /// for which n(p) is parallel to x - p. Along a boundary edge, n is linear.
  /// At a vertex, the normals of both edges are averaged unless they differ by
  /// more than 30 degrees.
  class CurveNormals
  {
  public:
    /// Collects the edges of the boundaries @p names of @p section.
    CurveNormals(const SectionMesh              &section,
                 const std::vector<std::string> &names);

    /// Returns the outward unit normal, extended from the boundaries to the
    /// point @p x of the section. All edges are searched.
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
