// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_gmsh_file_h
#define lamella_shape_gmsh_file_h

#include <lamella/base/entry.h>

#include <deal.II/base/point.h>

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Contents of a Gmsh mesh file. Each item has its line number for messages.
  struct GmshFile
  {
    /// Element types, as numbered by Gmsh.
    static constexpr int line_type = 1, triangle = 2, quadrilateral = 3,
                         point = 15;

    /// Name of a physical group and its line number in the file.
    struct Name
    {
      std::string  name;
      unsigned int line = 0;
    };

    /// A node with three coordinates in the file's unit of length.
    struct Node
    {
      dealii::Point<3> position;
      unsigned int     line = 0;
    };

    struct Element
    {
      /// Element type as numbered by Gmsh, e.g. GmshFile::triangle.
      int type = 0;
      /// Absolute tag of the physical group of the element; 0 if it has none.
      int          group = 0;
      unsigned int line  = 0;
      /// Node indices for points, lines, triangles and quadrilaterals.
      std::array<unsigned int, 4> nodes{};
    };

    /// Names of physical groups by dimension and tag.
    std::map<std::pair<int, int>, Name> names;
    /// Nodes and elements in the order of the file.
    std::vector<Node>    nodes;
    std::vector<Element> elements;
  };

  /// Throws InputError with the name of @p entry, its text (the file name), the
  /// number of the line, the rule and the remedy.
  [[noreturn]] void
  refuse_line(const Entry       &entry,
              const unsigned int line,
              const std::string &rule,
              const std::string &remedy = "");

  /// Parses @p text, a mesh in Gmsh's text format 4.1 (written since 2019) or
  /// 2.2. All numbers in the result are finite, numbers of nodes and elements
  /// are unique, and elements refer to existing nodes. Sections of the file
  /// that a plane mesh does not need (`$Comments`, `$Periodic`) are skipped.
  /// Throws InputError for @p entry, with line number, at the first error.
  GmshFile
  read_gmsh_file(const std::string &text, const Entry &entry);
} // namespace lamella

#endif
