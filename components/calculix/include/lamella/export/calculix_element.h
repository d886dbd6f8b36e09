// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_export_calculix_element_h
#define lamella_export_calculix_element_h

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace lamella
{
  /// A hexahedral element type of CalculiX: 20-node serendipity element with
  /// reduced integration (C3D20R), trilinear element with incompatible modes
  /// (C3D8I) or with reduced integration (C3D8R). Coordinates are in the unit
  /// cube [0, 1]^3. Nodes are in the order of CalculiX: corners of the bottom z
  /// = 0, corners of the top, then midpoints of bottom, top and vertical edges.
  class CalculixElement
  {
  public:
    /// Selects the type @p name. Throws InputError if the name is unknown.
    explicit CalculixElement(const std::string &name);

    /// Returns the name of the element type in CalculiX, such as C3D20R.
    const std::string &
    name() const
    {
      return element_name;
    }

    /// Returns the degree of the shape functions, 2 or 1.
    unsigned int
    degree() const
    {
      return unit_nodes.size() == 20 ? 2 : 1;
    }

    /// Returns the number of nodes of the element, 20 or 8.
    unsigned int
    n_nodes() const
    {
      return unit_nodes.size();
    }

    /// Returns the position of the node of index @p i in the unit cube.
    const dealii::Point<3> &
    unit_node(const unsigned int i) const
    {
      return unit_nodes[i];
    }

    /// Returns the shape functions N_i at x = @p unit in the unit cube, with r
    /// = 2 x - 1 and node i at r = r_i. Trilinear shape functions are
    ///   N_i = prod_d (1 + r_id r_d) / 2.
    /// For 20 nodes, corners have this product times (sum_d r_id r_d - 2).
    /// Midpoints have the factor 1 - r_d^2 in the direction of their edge.
    std::vector<double>
    shape_values(const dealii::Point<3> &unit) const;

    /// Returns the node indices, ascending, of face @p face in deal.II's order.
    std::vector<unsigned int>
    face_nodes(const unsigned int face) const;

  private:
    std::string element_name;
    /// Unit coordinates of the nodes.
    std::vector<dealii::Point<3>> unit_nodes;
  };

  /// Returns the number in CalculiX (1 to 6 for S1 to S6) of the element face
  /// of index @p face (0 to 5) in deal.II.
  unsigned int
  calculix_face(const unsigned int face);
} // namespace lamella

#endif
