// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_curve_normals_h
#define lamella_shape_curve_normals_h

#include <lamella/shape/section_mesh.h>

#include <array>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * The outward normals of boundaries of a section, carried to all points of
   * the section: at a point that of its foot on the nearest side. On a side
   * normals go linearly from end to end between the means of neighbours, and
   * the foot of a point x is where x - foot is parallel to them: of short sides
   * of a circle that is the polar direction, exactly. Where two sides meet at
   * more than 30 degrees each keeps its own.
   */
  class CurveNormals
  {
  public:
    /// Of the boundaries @p names of @p section, which must have them.
    CurveNormals(const SectionMesh              &section,
                 const std::vector<std::string> &names);

    /// A unit vector, (n_x, n_z). Costs a look at all sides.
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
