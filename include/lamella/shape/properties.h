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
  /// Geometric properties of a section with its curved edges, by Gauss' rule on
  /// a geometry of degree 6, nearly exact to rounding. For reports and
  /// references, not for the stiffness.
  struct SectionProperties
  {
    /// Sum of the ply areas [length^2].
    double area = 0.;
    /// Centroid (x, z) of the area, regardless of materials [length].
    dealii::Point<2> centroid;
    /// Second moments about the centroid, int x'^2 dA, int z'^2 dA and int x'
    /// z' dA, as {{xx, xz}, {xz, zz}} [length^4].
    dealii::Tensor<2, 2> second_moments;
    /// Area of each ply [length^2], in the order of SectionMesh::plies.
    std::vector<double> ply_areas;
    /// Length of boundaries by name, along curved edges.
    std::map<std::string, double> boundary_lengths;
    /// Corners of the vertices' bounding box. Arcs may exceed it.
    dealii::Point<2> low, high;
  };

  /// Returns the properties of @p section, in one pass over its cells.
  SectionProperties
  section_properties(const SectionMesh &section);

  /// Throws InputError of @p entry, the mesh's source, unless each cell is
  /// convex with inner angles between 0 and 180 degrees (positive Jacobian), no
  /// two vertices coincide, and all cells are connected by sides. Checks in
  /// this order; the message has the number of faulty cells and the first one's
  /// place. Vertices coincide if they are closer than 1e-6 of the shortest edge
  /// in each coordinate. n log n for n vertices.
  void
  check_section_mesh(const SectionMesh &section, const Entry &entry);

  /// Throws InputError of the subsection @p path for a cell with an aspect
  /// ratio above 2e6, the square of the diameter over the area: its stiffnesses
  /// across and along differ by the square of that, which leaves no digits for
  /// bending.
  void
  check_proportions(const SectionMesh &section, const std::string &path);
} // namespace lamella

#endif
