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
  /// a geometry of degree 6. For reports and references.
  struct SectionProperties
  {
    /// Sum of the ply areas [length^2].
    double area = 0.;
    /// Centroid (x, z) of the area, regardless of materials [length].
    dealii::Point<2> centroid;
    /// Second moments about the centroid, {{xx, xz}, {xz, zz}}, xx = int x'^2
    /// dA [length^4].
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
  /// convex with positive Jacobian, no two vertices coincide, and all cells are
  /// connected by sides. The message has the number of faulty cells and the
  /// first one's position. Vertices coincide if they are closer than 1e-6 of
  /// the shortest edge in each coordinate.
  void
  check_section_mesh(const SectionMesh &section, const Entry &entry);

  /// Throws InputError of the subsection @p path for a cell with an aspect
  /// ratio above 2e6, the square of the diameter over the area. Its stiffnesses
  /// across and along would differ by the square of that.
  void
  check_proportions(const SectionMesh &section, const std::string &path);
} // namespace lamella

#endif
