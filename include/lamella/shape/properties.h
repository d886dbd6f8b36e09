// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_properties_h
#define lamella_shape_properties_h

#include <lamella/shape/section_mesh.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <map>
#include <string>
#include <vector>

namespace lamella
{
  /// What the geometry of a section amounts to, its curved edges followed.
  struct SectionProperties
  {
    double           area = 0.;
    dealii::Point<2> centroid;
    /// About the centroid: int x'^2 dA, int z'^2 dA and int x' z' dA, as
    /// {{xx, xz}, {xz, zz}} [length^4].
    dealii::Tensor<2, 2> second_moments;
    /// Of each ply.
    std::vector<double> ply_areas;
    /// Name of a boundary -> its length.
    std::map<std::string, double> boundary_lengths;
    /// The corners of the smallest box around the vertices.
    dealii::Point<2> low, high;
  };

  SectionProperties
  section_properties(const SectionMesh &section);

  /**
   * Throws InputError, beginning with @p what, unless each cell is convex with
   * inner angles between 0 and 180 degrees (so that the Jacobian is positive),
   * no two vertices share a place, and all cells hang together by their sides.
   */
  void
  check_section_mesh(const SectionMesh &section, const std::string &what);

  /**
   * Throws InputError, beginning with @p what, for a cell that is more than
   * 2e6 times as long as thick: its stiffness across and along differ by the
   * square of that, so that doubles have nothing left for what bends it.
   */
  void
  check_proportions(const SectionMesh &section, const std::string &what);
} // namespace lamella

#endif
