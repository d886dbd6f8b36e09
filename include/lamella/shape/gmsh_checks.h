// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_gmsh_checks_h
#define lamella_shape_gmsh_checks_h

#include <lamella/shape/gmsh_file.h>

#include <deal.II/grid/tria.h>

#include <vector>

namespace lamella
{
  /// Section mesh of a Gmsh file, for Triangulation::create_triangulation().
  struct GmshMesh
  {
    std::vector<dealii::Point<2>>    vertices; ///< Positions (x, z) [length].
    std::vector<dealii::CellData<2>> cells;    ///< Vertices and ply of cells.
    dealii::SubCellData              rest;     ///< Boundary lines.
    std::vector<const GmshFile::Element *>
      elements, ///< Element of the file for each cell.
      lines;    ///< Element of the file for each boundary line.
  };

  /// Throws InputError for @p entry (the file name), with the line number in
  /// the file, if a cell of @p mesh is not convex.
  void
  check_cells_are_convex(const GmshMesh &mesh, const Entry &entry);

  /// Throws InputError for @p entry (the file name) if the sum of the angles of
  /// the cells at a vertex exceeds 360 degrees, so that cells overlap.
  void
  check_angles(const GmshMesh &mesh, const Entry &entry);

  /// Removes lines of @p mesh that are not sides of cells. Throws InputError
  /// for @p entry if a line is between two cells or belongs to two boundaries.
  void
  keep_boundary_lines(GmshMesh &mesh, const Entry &entry);
} // namespace lamella

#endif
