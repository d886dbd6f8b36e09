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
  /// Contents of a Gmsh mesh file. Each part has its line in the file.
  struct GmshFile
  {
    /// Element types, as numbered by Gmsh.
    static constexpr int line_type = 1, triangle = 2, quadrilateral = 3,
                         point = 15;

    /// Name of a physical group, with its line in the file.
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
      /// Element type, one of the above or another of Gmsh's.
      int type = 0;
      /// Tag of its physical group without sign (orientation); 0 for none.
      int          group = 0;
      unsigned int line  = 0;
      /// Indices in @p nodes below. Not set for other types than those above.
      std::array<unsigned int, 4> nodes{};
    };

    /// (dimension, tag) -> name of a physical group.
    std::map<std::pair<int, int>, Name> names;
    /// Nodes and elements in the order of the file.
    std::vector<Node>    nodes;
    std::vector<Element> elements;
  };

  /// Throws InputError `PATH = FILE: line LINE: RULE. REMEDY` of @p entry.
  [[noreturn]] void
  refuse_line(const Entry       &entry,
              const unsigned int line,
              const std::string &rule,
              const std::string &remedy = "");

  /// Parses @p text, a mesh in Gmsh's text format 4.1 (written since 2019) or
  /// 2.2. The result is consistent: numbers are finite, nodes and elements are
  /// numbered once, and elements refer to existing nodes. Parts without use for
  /// a plane mesh (`$Comments`, `$Periodic`) are skipped. Throws InputError of
  /// @p entry, `Section NAME/File`, with line, error and remedy, at the first
  /// error. No file is opened.
  GmshFile
  read_gmsh_file(const std::string &text, const Entry &entry);
} // namespace lamella

#endif
