// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_gmsh_checks_h
#define lamella_shape_gmsh_checks_h

#include <lamella/shape/gmsh_file.h>

#include <deal.II/grid/tria.h>

#include <vector>

namespace lamella
{
  /// Input of Triangulation, with the elements of the file that it is from.
  struct GmshMesh
  {
    std::vector<dealii::Point<2>>          vertices;
    std::vector<dealii::CellData<2>>       cells;
    dealii::SubCellData                    rest;
    std::vector<const GmshFile::Element *> elements, lines;
  };

  /// Throws InputError, with its line in the file, if a cell is not convex.
  void
  check_cells_are_convex(const GmshMesh &mesh, const Entry &entry);

  /// Throws InputError if the cells around a vertex exceed a full angle:
  /// overlapping cells with wrong node numbers.
  void
  check_angles(const GmshMesh &mesh, const Entry &entry);

  /// Keeps the lines of @p mesh that are sides at the boundary. Throws
  /// InputError if a line is inside, or belongs to two boundaries.
  void
  keep_boundary_lines(GmshMesh &mesh, const Entry &entry);
} // namespace lamella

#endif
