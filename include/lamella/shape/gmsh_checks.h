// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_gmsh_checks_h
#define lamella_shape_gmsh_checks_h

#include <lamella/shape/gmsh_file.h>

#include <deal.II/grid/tria.h>

#include <vector>

namespace lamella
{
  /// Mesh data for Triangulation::create_triangulation(). `elements` and
  /// `lines` have the element of the Gmsh file for each cell and each line.
  struct GmshMesh
  {
    std::vector<dealii::Point<2>>          vertices;
    std::vector<dealii::CellData<2>>       cells;
    dealii::SubCellData                    rest;
    std::vector<const GmshFile::Element *> elements, lines;
  };

  /// Throws InputError with the file's line number if a cell is not convex.
  void
  check_cells_are_convex(const GmshMesh &mesh, const Entry &entry);

  /// Throws InputError if the angles of the cells at a vertex exceed 360
  /// degrees in sum, so that cells overlap.
  void
  check_angles(const GmshMesh &mesh, const Entry &entry);

  /// Removes the lines of @p mesh that are not sides of cells. Throws
  /// InputError if a line is an interior side or belongs to two boundaries.
  void
  keep_boundary_lines(GmshMesh &mesh, const Entry &entry);
} // namespace lamella

#endif
