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
  /**
   * What the text of a mesh by Gmsh says, before anything is made of it. Each
   * part knows its line in the file, so that whoever finds a fault in it can
   * say where. Nothing here knows what a section is: gmsh.cc judges that, and
   * turns this into a SectionMesh.
   */
  struct GmshFile
  {
    /// Types of elements, as Gmsh counts them.
    static constexpr int line_type = 1, triangle = 2, quadrilateral = 3,
                         point = 15;

    /// Of a physical group, with the line of the file that gives it.
    struct Name
    {
      std::string  name;
      unsigned int line = 0;
    };

    /// All three coordinates, in the unit of length of the file.
    struct Node
    {
      dealii::Point<3> position;
      unsigned int     line = 0;
    };

    struct Element
    {
      /// One of the types above, or another of Gmsh's.
      int type = 0;
      /// Tag of its physical group, without the sign (which says that the group
      /// takes it backwards); 0 if it is in none.
      int          group = 0;
      unsigned int line  = 0;
      /// Places in @p nodes below, in the order of the file, as many as the
      /// types named above have; of other types they are not kept.
      std::array<unsigned int, 4> nodes{};
    };

    /// (dimension, tag) -> name of a physical group. Dimension 1 names
    /// boundaries, dimension 2 parts.
    std::map<std::pair<int, int>, Name> names;
    /// In the order of the file, as are the elements.
    std::vector<Node>    nodes;
    std::vector<Element> elements;
  };

  /// Throws InputError: in the file that @p entry names @p line breaks the
  /// @p rule (`PATH = FILE: line LINE: RULE. REMEDY`). Lines are counted from
  /// 1, as editors do.
  [[noreturn]] void
  refuse_line(const Entry       &entry,
              const unsigned int line,
              const std::string &rule,
              const std::string &remedy = "");

  /**
   * Understands @p text, a mesh in Gmsh's format 4.1, which it writes since
   * 2019, or 2.2, which most others write, as text. Any other is refused with
   * its version and the command that makes a 4.1 of it.
   *
   * What comes back hangs together: all counts are those announced, all numbers
   * are finite, the nodes and elements numbered once, and each element's nodes
   * are there. Sections that a mesh of a plane has no use for (`$Comments`,
   * `$Periodic`, ...) are passed over. Time and memory go with the length of
   * the text, whatever numbers stand in it.
   *
   * Throws InputError of @p entry, which names the file, with the line, the
   * fault and the remedy, if anything else stands there: a file that is damaged
   * in one place is more often wrong in others than it is right.
   * @param text  the whole file; binary ones are refused
   * @param entry `Section NAME/File`, for messages only: no file is opened here
   */
  GmshFile
  read_gmsh_file(const std::string &text, const Entry &entry);
} // namespace lamella

#endif
