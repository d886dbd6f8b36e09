// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_gmsh_checks_h
#define lamella_shape_gmsh_checks_h

#include <lamella/shape/gmsh_file.h>

#include <deal.II/grid/tria.h>

#include <vector>

namespace lamella
{
  /// What Triangulation takes, and which elements of the file it is from.
  struct GmshMesh
  {
    std::vector<dealii::Point<2>>          vertices;
    std::vector<dealii::CellData<2>>       cells;
    dealii::SubCellData                    rest;
    std::vector<const GmshFile::Element *> elements, lines;
  };

  /// Throws InputError if a cell is not convex. check_section_mesh() would,
  /// too, but does not know the line.
  void
  check_cells_are_convex(const GmshMesh &mesh, const Entry &entry);

  /// Throws InputError if the cells go around some vertex more than once:
  /// cells whose numbers are mixed up may cover others without a common side.
  void
  check_angles(const GmshMesh &mesh, const Entry &entry);

  /// Leaves of @p mesh's lines those that are sides at the boundary. Throws
  /// InputError if one runs inside, or is two boundaries.
  void
  sift_lines(GmshMesh &mesh, const Entry &entry);
} // namespace lamella

#endif
