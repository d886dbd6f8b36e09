// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_properties_h
#define lamella_shape_properties_h

#include <lamella/base/entry.h>
#include <lamella/shape/section_mesh.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <map>
#include <string>
#include <vector>

namespace lamella
{
  /// What the geometry of a section amounts to, its curved edges followed. By
  /// Gauss' rule on a geometry of degree 6, exact to rounding or nearly. For
  /// reports and references; the stiffness integrates for itself.
  struct SectionProperties
  {
    /// [length^2], the sum of the ply areas.
    double area = 0.;
    /// Of the area, whatever the materials: (x, z) [length].
    dealii::Point<2> centroid;
    /// About the centroid: int x'^2 dA, int z'^2 dA and int x' z' dA, as
    /// {{xx, xz}, {xz, zz}} [length^4].
    dealii::Tensor<2, 2> second_moments;
    /// Of each ply [length^2], in the order of SectionMesh::plies.
    std::vector<double> ply_areas;
    /// Name of a boundary -> its length. Along the curved edges; boundaries of
    /// one name add up.
    std::map<std::string, double> boundary_lengths;
    /// The corners of the smallest box around the vertices. An arc may bulge
    /// out between two of them.
    dealii::Point<2> low, high;
  };

  /// The properties of @p section, in one pass over its cells.
  SectionProperties
  section_properties(const SectionMesh &section);

  /**
   * Throws InputError of @p entry, which the mesh is from, unless each cell is
   * convex with inner angles between 0 and 180 degrees (so that the Jacobian is
   * positive), no two vertices share a place, and all cells hang together by
   * their sides. In this order; the message says how many cells are at fault
   * and where the first is. Two vertices share a place if they are nearer than
   * 1e-6 of the shortest edge, in each coordinate. n log n for n vertices.
   */
  void
  check_section_mesh(const SectionMesh &section, const Entry &entry);

  /**
   * Throws InputError of the subsection @p path for a cell that is more than
   * 2e6 times as long as thick: its stiffness across and along differ by the
   * square of that, so that doubles have nothing left for what bends it. As
   * long as thick means the square of the diameter over the area.
   */
  void
  check_proportions(const SectionMesh &section, const std::string &path);
} // namespace lamella

#endif
