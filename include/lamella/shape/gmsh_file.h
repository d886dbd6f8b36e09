// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_gmsh_file_h
#define lamella_shape_gmsh_file_h

#include <lamella/base/entry.h>

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Nodes, elements and physical groups of a Gmsh mesh file. `line` is the
  /// line number of each item in the file, for messages.
  struct GmshFile
  {
    /// Element type line, as numbered by Gmsh.
    static constexpr int line_type = 1,  ///< Line with two nodes.
      triangle                     = 2,  ///< Triangle with three nodes.
      quadrilateral                = 3,  ///< Quadrilateral with four nodes.
      point                        = 15; ///< Point with one node.

    /// Name of a physical group.
    struct Name
    {
      std::string  name;     ///< Name without quotation marks.
      unsigned int line = 0; ///< Line number in the file, from 1.
    };

    /// A node of the mesh.
    struct Node
    {
      dealii::Point<3> position; ///< Coordinates in the file's unit of length.
      unsigned int     line = 0; ///< Line number in the file, from 1.
    };

    /// An element of the mesh.
    struct Element
    {
      /// Element type as numbered by Gmsh, e.g. GmshFile::triangle.
      int type = 0;
      /// Tag of the element's physical group without sign; 0 if it has none.
      int          group = 0;
      unsigned int line  = 0; ///< Line number in the file, from 1.
      /// Indices of its 1 to 4 nodes in GmshFile::nodes; unused entries are 0.
      std::array<unsigned int, 4> nodes{};
    };

    /// Names of physical groups; the key is (dimension, tag).
    std::map<std::pair<int, int>, Name> names;
    std::vector<Node>    nodes;    ///< Nodes in the order of the file.
    std::vector<Element> elements; ///< Elements in the order of the file.
  };

  /// Throws InputError with the name of @p entry, its text (the file name), the
  /// number of the line, the violated @p rule and the @p remedy.
  [[noreturn]] void
  refuse_line(const Entry       &entry,
              const unsigned int line,
              const std::string &rule,
              const std::string &remedy = "");

  /// Parses @p text, a mesh in Gmsh's text format 4.1 (written since 2019). All
  /// numbers in the result are finite, numbers of nodes and elements are
  /// unique, and elements refer to existing nodes. Sections of the file that a
  /// plane mesh does not need (`$Comments`, `$Periodic`) are skipped. Throws
  /// InputError for @p entry, with the line number, at the first error.
  GmshFile
  read_gmsh_file(const std::string &text, const Entry &entry);

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
