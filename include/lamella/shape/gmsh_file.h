// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_gmsh_file_h
#define lamella_shape_gmsh_file_h

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
   * say where.
   */
  struct GmshFile
  {
    /// Types of elements, as Gmsh counts them.
    static constexpr int line_type = 1, triangle = 2, quadrilateral = 3,
                         point = 15;

    /// Of a physical group.
    struct Name
    {
      std::string  name;
      unsigned int line = 0;
    };

    struct Node
    {
      dealii::Point<3> position;
      unsigned int     line = 0;
    };

    struct Element
    {
      int type = 0;
      /// Tag of its physical group, without the sign (which says that the group
      /// takes it backwards); 0 if it is in none.
      int          group = 0;
      unsigned int line  = 0;
      /// Places in @p nodes below, in the order of the file, as many as the
      /// types named above have; of other types they are not kept.
      std::array<unsigned int, 4> nodes{};
    };

    /// (dimension, tag) -> name of a physical group.
    std::map<std::pair<int, int>, Name> names;
    /// In the order of the file, as are the elements.
    std::vector<Node>    nodes;
    std::vector<Element> elements;
  };

  /// @p what, which names the entry and the file, and @p line: what messages
  /// about that line begin with.
  std::string
  at_line(const std::string &what, const unsigned int line);

  /**
   * Understands @p text, a mesh in one of Gmsh's formats 2.0 to 2.2, 4.0 and
   * 4.1, as text.
   *
   * What comes back hangs together: all counts are those announced, all numbers
   * are finite, the nodes and elements numbered once, and each element's nodes
   * are there. Sections that a mesh of a plane has no use for (`$Comments`,
   * `$Periodic`, ...) are passed over. Time and memory go with the length of
   * the text, whatever numbers stand in it.
   *
   * Throws InputError, with @p what, the line, the fault and the remedy, if
   * anything else stands there: a file that is damaged in one place is more
   * often wrong in others than it is right.
   */
  GmshFile
  read_gmsh_file(const std::string &text, const std::string &what);
} // namespace lamella

#endif
