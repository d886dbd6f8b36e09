// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_export_calculix_element_h
#define lamella_export_calculix_element_h

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * A hexahedron of CalculiX: the serendipity element of 20 nodes with reduced
   * integration (C3D20R), or the trilinear one with incompatible modes (C3D8I)
   * or reduced integration (C3D8R). Points are those of the unit cube
   * [0, 1]^3, faces and nodes in CalculiX' order (its manual, "Eight-node brick
   * element" and "Twenty-node brick element").
   */
  class CalculixElement
  {
  public:
    /// Throws InputError for other names than the three.
    explicit CalculixElement(const std::string &name);

    const std::string &
    name() const
    {
      return element_name;
    }

    /// Of the hexahedra that have these nodes: 2 for 20 nodes, 1 for 8.
    unsigned int
    degree() const
    {
      return unit_nodes.size() == 20 ? 2 : 1;
    }

    unsigned int
    n_nodes() const
    {
      return unit_nodes.size();
    }

    /// The place of node @p i, from 0.
    const dealii::Point<3> &
    unit_node(const unsigned int i) const
    {
      return unit_nodes[i];
    }

    /// The values of the shape functions at @p unit.
    std::vector<double>
    shape_values(const dealii::Point<3> &unit) const;

    /// The nodes of deal.II's face @p face.
    std::vector<unsigned int>
    face_nodes(const unsigned int face) const;

  private:
    std::string                   element_name;
    std::vector<dealii::Point<3>> unit_nodes;
  };

  /// The number, 1 to 6, that CalculiX gives deal.II's face @p face.
  unsigned int
  calculix_face(const unsigned int face);
} // namespace lamella

#endif
