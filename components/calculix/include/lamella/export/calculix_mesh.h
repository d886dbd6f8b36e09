// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_export_calculix_mesh_h
#define lamella_export_calculix_mesh_h

#include <lamella/export/calculix_element.h>
#include <lamella/scene/scene.h>

#include <iosfwd>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  class Solid;

  /// Faces of elements: number of the element, deal.II's number of the face.
  using CalculixFaces = std::vector<std::pair<unsigned int, unsigned int>>;

  /// Bodies of a scene as hexahedra of CalculiX for any theories: the solids of
  /// `Theory = solid-2` (or solid-1), without nodes that the element lacks. A
  /// section cell times an axis element is a hexahedron within one ply; plies
  /// are element sets with an orientation each. Nodes and elements are numbered
  /// from 1, body by body; positions are in the scene's axes. Refers to the
  /// scene.
  class CalculixMesh
  {
  public:
    /// Makes the solids of @p scene, of the degree of @p element, and numbers
    /// their nodes and cells. Throws InputError for hanging nodes (Refine
    /// near), and for C3D20R if a body is a single row of cells.
    CalculixMesh(const Scene &scene, const CalculixElement &element);

    /// Returns the solids in the order of the scene, with their cells as
    /// elements (element_of()).
    const Bodies &
    bodies() const
    {
      return solids;
    }

    /// Returns the element type of all bodies.
    const CalculixElement &
    element() const
    {
      return element_type;
    }

    /// Returns the position of node @p number, from 1, in the scene's axes.
    const dealii::Point<3> &
    node(const unsigned int number) const
    {
      return nodes[number - 1];
    }

    /// Returns the number of nodes of all bodies.
    unsigned int
    n_nodes() const
    {
      return nodes.size();
    }

    /// Returns the number of elements of all bodies.
    unsigned int
    n_elements() const
    {
      return elements.size();
    }

    /// Returns the first node and the first element of @p body, from 0; one
    /// past the last for the number of bodies.
    const std::pair<unsigned int, unsigned int> &
    first_of(const unsigned int body) const
    {
      return firsts[body];
    }

    /// Returns the element of the solid's cell @p cell (Location::Place).
    unsigned int
    element_of(const unsigned int body, const unsigned int cell) const
    {
      return firsts[body].second + cell;
    }

    /// Returns the nodes of element @p number, in CalculiX' order.
    const std::vector<unsigned int> &
    nodes_of(const unsigned int number) const
    {
      return elements[number - 1];
    }

    /// Returns the faces of @p surface of @p body (bottom, start, ...).
    CalculixFaces
    faces(const unsigned int body, const std::string &surface) const;

    /// Returns the node of @p body at @p location, within 1e-6 in each unit
    /// coordinate, or 0.
    unsigned int
    node_at(const unsigned int body, const Location &location) const;

    /// Returns the nodes of @p region, for a support. Throws InputError, of the
    /// subsection @p path, if a point is not a node or a line does not follow
    /// edges.
    std::set<unsigned int>
    region_nodes(const Region &region, const std::string &path) const;

    /// Writes the cards of nodes, elements, materials, ply axes and sections,
    /// with the sets BODY1 (nodes) and BODY1_PLY1 (elements), counted from 1.
    /// Isotropic materials have E and nu, others nine engineering constants in
    /// the ply's axes.
    void
    write(std::ostream &deck) const;

  private:
    /// Adds nodes and elements of @p body, without unused nodes.
    void
    number(const unsigned int body);
    /// Throws InputError if @p body, the last one numbered, is one hexahedron
    /// wide in two directions: C3D20R then has unconstrained hourglass modes.
    void
    refuse_single_row(const unsigned int body) const;
    /// Returns region_nodes() of a straight line.
    std::set<unsigned int>
    line_nodes(const Region &region, const std::string &path) const;
    /// Writes MATERIAL1, ..., in ascending order of names.
    void
    write_materials(std::ostream &deck) const;
    /// Writes material and axes of the plies of @p body.
    void
    write_sections(std::ostream &deck, const unsigned int body) const;

    const Scene    &scene;
    CalculixElement element_type;
    Bodies          solids;
    /// First node and first element of each body, and one past the last.
    std::vector<std::pair<unsigned int, unsigned int>> firsts;
    /// Nodes and elements by their number less one.
    std::vector<dealii::Point<3>>          nodes;
    std::vector<std::vector<unsigned int>> elements;
    /// Ply of each element in its section, from 0 at the bottom.
    std::vector<unsigned int> plies;
  };

  /// Returns @p value with 13 digits and an exponent, in up to 20 characters.
  std::string
  calculix_number(const double value);

  /// Writes the line of a node or an element: its number, then coordinates or
  /// nodes (CalculiX allows sixteen entries per line).
  void
  write_node(std::ostream           &deck,
             const unsigned int      number,
             const dealii::Point<3> &position);
  void
  write_element(std::ostream                    &deck,
                const unsigned int               number,
                const std::vector<unsigned int> &nodes);

  /// Writes the card @p keyword and the numbers of @p set.
  void
  write_set(std::ostream                 &deck,
            const std::string            &keyword,
            const std::set<unsigned int> &set);
} // namespace lamella

#endif
