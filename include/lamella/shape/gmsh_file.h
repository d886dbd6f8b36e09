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
  /// Contents of a Gmsh mesh file. Each part has its line in the file, for
  /// messages. gmsh.cc turns it into a SectionMesh.
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
      /// Tag of its physical group without sign (orientation); 0 if it has
      /// none.
      int          group = 0;
      unsigned int line  = 0;
      /// Indices in @p nodes below, in the order of the file. Not set for other
      /// types than those above.
      std::array<unsigned int, 4> nodes{};
    };

    /// (dimension, tag) -> name of a physical group: boundaries of dimension 1,
    /// parts of dimension 2.
    std::map<std::pair<int, int>, Name> names;
    /// Nodes and elements in the order of the file.
    std::vector<Node>    nodes;
    std::vector<Element> elements;
  };

  /// Throws InputError: @p line, from 1, of the file that @p entry names breaks
  /// the @p rule (`PATH = FILE: line LINE: RULE. REMEDY`).
  [[noreturn]] void
  refuse_line(const Entry       &entry,
              const unsigned int line,
              const std::string &rule,
              const std::string &remedy = "");

  /**
   * Parses @p text, a mesh in Gmsh's text format 4.1 (written since 2019) or
   * 2.2. Other formats are rejected, with their version and the command that
   * converts them to 4.1.
   *
   * The result is consistent: counts are those announced, numbers are finite,
   * nodes and elements are numbered once, and elements refer to existing nodes.
   * Sections without use for a plane mesh (`$Comments`, `$Periodic`, ...) are
   * skipped. Time and memory are proportional to the length of the text.
   *
   * Throws InputError of @p entry, with line, error and remedy, at the first
   * deviation.
   *
   * @param text the whole file; binary files are rejected
   * @param entry `Section NAME/File`, for messages; no file is opened here
   */
  GmshFile
  read_gmsh_file(const std::string &text, const Entry &entry);
} // namespace lamella

#endif
