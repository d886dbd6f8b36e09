// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_export_calculix_element_h
#define lamella_export_calculix_element_h

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace lamella
{
  /// A hexahedron of CalculiX: the 20-node serendipity element with reduced
  /// integration (C3D20R), or the trilinear one with incompatible modes (C3D8I)
  /// or reduced integration (C3D8R). Points are those of the unit cube [0,
  /// 1]^3, faces and nodes in CalculiX' order (manual, "Eight-node brick
  /// element" and "Twenty-node brick element"): corners around the bottom z =
  /// 0, then the top, then midpoints of bottom, top and upright edges.
  class CalculixElement
  {
  public:
    /// Throws InputError, with the nearest name, if @p name is not known.
    explicit CalculixElement(const std::string &name);

    /// Returns the name in a deck.
    const std::string &
    name() const
    {
      return element_name;
    }

    /// Returns the degree of the hexahedra with these nodes: 2 for 20, 1 for 8.
    unsigned int
    degree() const
    {
      return unit_nodes.size() == 20 ? 2 : 1;
    }

    /// Returns the number of nodes, 20 or 8.
    unsigned int
    n_nodes() const
    {
      return unit_nodes.size();
    }

    /// Returns the position of node @p i, from 0, in the unit cube.
    const dealii::Point<3> &
    unit_node(const unsigned int i) const
    {
      return unit_nodes[i];
    }

    /// Returns the shape functions N_i at @p unit, with r = 2 x - 1 in [-1, 1]
    /// and the node at r_i. The trilinear ones are
    ///   N_i = prod_d (1 + r_id r_d) / 2,
    /// serendipity at corners (prod_d (1 + r_id r_d) / 2) (sum_d r_id r_d - 2),
    /// and at midpoints of edges with 1 - r_d^2 in the direction of the edge.
    std::vector<double>
    shape_values(const dealii::Point<3> &unit) const;

    /// Returns the nodes, from 0, of deal.II's face @p face (x = 0, x = 1,
    /// y = 0, ...) in ascending order.
    std::vector<unsigned int>
    face_nodes(const unsigned int face) const;

  private:
    std::string element_name;
    /// unit_node() of each node.
    std::vector<dealii::Point<3>> unit_nodes;
  };

  /// Returns CalculiX' number, 1 to 6 as in S1 to S6, of deal.II's face
  /// @p face, 0 to 5.
  unsigned int
  calculix_face(const unsigned int face);
} // namespace lamella

#endif
