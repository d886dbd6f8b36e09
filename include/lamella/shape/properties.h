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
  /// Geometric properties of a section, integrated by Gauss' rule with curved
  /// edges of degree 6. Used in reports only.
  struct SectionProperties
  {
    double area = 0.; ///< Sum of the ply areas [length^2].
    /// Centroid (x, z) of the area, not weighted with moduli [length].
    dealii::Point<2> centroid;
    /// Second moments about the centroid, e.g. xx = int (x - x_c)^2 dA
    /// [length^4].
    dealii::Tensor<2, 2> second_moments;
    /// Area of each ply [length^2], in the order of SectionMesh::plies.
    std::vector<double> ply_areas;
    /// Arc length of each boundary, by name [length].
    std::map<std::string, double> boundary_lengths;
    /// Lower left corner of the bounding box of the vertices (x, z) [length].
    dealii::Point<2> low;
    dealii::Point<2> high; ///< Upper right corner of the box [length].
  };

  /// Computes the properties of @p section.
  SectionProperties
  section_properties(const SectionMesh &section);

  /// Throws InputError for @p entry, which describes the mesh, unless each cell
  /// is convex with positive Jacobian, no two vertices coincide, and all cells
  /// are connected by sides. The message has the number of faulty cells and the
  /// position of the first. Vertices coincide if their coordinates differ by
  /// less than 1e-6 of the shortest edge.
  void
  check_section_mesh(const SectionMesh &section, const Entry &entry);

  /// Throws InputError for the subsection @p path if a cell has an aspect ratio
  /// (diameter^2 / area) above 2e6. Its stiffnesses in the two directions would
  /// differ by the square of this ratio, too much for double precision.
  void
  check_proportions(const SectionMesh &section, const std::string &path);
} // namespace lamella

#endif
