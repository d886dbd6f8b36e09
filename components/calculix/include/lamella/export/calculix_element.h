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
   * element" and "Twenty-node brick element"): the corners around the bottom
   * z = 0, counter-clockwise, and around the top, then the middles of the edges
   * of the bottom, of the top, and of the upright ones.
   */
  class CalculixElement
  {
  public:
    /// Throws InputError for other names than the three, and says which is the
    /// nearest.
    explicit CalculixElement(const std::string &name);

    /// As it stands in a deck.
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

    /// 20 or 8.
    unsigned int
    n_nodes() const
    {
      return unit_nodes.size();
    }

    /// The place of node @p i, from 0, in the unit cube.
    const dealii::Point<3> &
    unit_node(const unsigned int i) const
    {
      return unit_nodes[i];
    }

    /**
     * The values N_i of the shape functions at @p unit, one a node; they sum to
     * one. With r = 2 x - 1 in [-1, 1] and the node at r_i: trilinear
     *   N_i = prod_d (1 + r_id r_d) / 2;
     * serendipity at corners (prod_d (1 + r_id r_d) / 2) (sum_d r_id r_d - 2),
     * and at the middles of edges with 1 - r_d^2 in the direction of the edge.
     * Incompatible modes have no part in them: these are the displacements that
     * nodes determine.
     */
    std::vector<double>
    shape_values(const dealii::Point<3> &unit) const;

    /// The nodes, from 0, of deal.II's face @p face (x = 0, x = 1, y = 0, ...),
    /// by rising number, not around it.
    std::vector<unsigned int>
    face_nodes(const unsigned int face) const;

  private:
    std::string element_name;
    /// unit_node() of each.
    std::vector<dealii::Point<3>> unit_nodes;
  };

  /// The number, 1 to 6, that CalculiX gives deal.II's face @p face, 0 to 5:
  /// the S1 ... S6 of its surfaces.
  unsigned int
  calculix_face(const unsigned int face);
} // namespace lamella

#endif
