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

  /// Element faces: pairs of an element number and deal.II's index of the face.
  using CalculixFaces = std::vector<std::pair<unsigned int, unsigned int>>;

  /// Mesh of all bodies of a scene with hexahedra of CalculiX, for any theory.
  /// A cell of the section mesh times an axis element is a hexahedron within
  /// one ply. Plies are element sets with an orientation. Nodes and elements
  /// are numbered from 1, body after body. Keeps a reference to the scene.
  class CalculixMesh
  {
  public:
    /// Meshes the bodies of @p scene with elements @p element. Throws
    /// InputError for hanging nodes (Refine near), and for C3D20R if a body is
    /// one element wide in two directions.
    CalculixMesh(const Scene &scene, const CalculixElement &element);

    /// Returns the meshed bodies (instances of Solid) in the scene's order.
    const Bodies &
    bodies() const
    {
      return solids;
    }

    /// Returns the element type.
    const CalculixElement &
    element() const
    {
      return element_type;
    }

    /// Returns the position of the node of number @p number (from 1).
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

    /// Returns the numbers of the first node and the first element of the body
    /// of index @p body; for the number of bodies, one past the last.
    const std::pair<unsigned int, unsigned int> &
    first_of(const unsigned int body) const
    {
      return firsts[body];
    }

    /// Returns the number of the element at mesh cell @p cell of @p body.
    unsigned int
    element_of(const unsigned int body, const unsigned int cell) const
    {
      return firsts[body].second + cell;
    }

    /// Returns the node numbers of element @p number in the order of CalculiX.
    const std::vector<unsigned int> &
    nodes_of(const unsigned int number) const
    {
      return elements[number - 1];
    }

    /// Returns the element faces of @p surface (bottom, start, ...) of @p body.
    CalculixFaces
    faces(const unsigned int body, const std::string &surface) const;

    /// Returns the number of the node of @p body at @p location (tolerance 1e-6
    /// in unit coordinates), or 0 if there is none.
    unsigned int
    node_at(const unsigned int body, const Location &location) const;

    /// Returns the numbers of the nodes on @p region of a support. Throws
    /// InputError, which names the subsection @p path, if a point is not at a
    /// node or a line is not along element edges.
    std::set<unsigned int>
    region_nodes(const Region &region, const std::string &path) const;

    /// Writes nodes, elements, materials, ply axes and sections, with sets
    /// BODY1 (nodes), BODY1_PLY1 (elements), etc. Isotropic materials have E
    /// and nu, others nine engineering constants in ply axes.
    void
    write(std::ostream &deck) const;

  private:
    /// Numbers nodes and elements of @p body, without unused nodes.
    void
    number(const unsigned int body);
    /// Throws InputError if @p body is one hexahedron wide in two directions,
    /// since C3D20R then has unconstrained hourglass modes.
    void
    refuse_single_row(const unsigned int body) const;
    /// Returns region_nodes() for a line.
    std::set<unsigned int>
    line_nodes(const Region &region, const std::string &path) const;
    /// Writes the materials MATERIAL1, ..., sorted by name.
    void
    write_materials(std::ostream &deck) const;
    /// Writes the ply axes SET_AXES of the ply of index @p ply of @p body,
    /// whose element set is @p set: one orientation, or one per element at its
    /// center if the ply follows a curved wall.
    void
    write_orientation(std::ostream      &deck,
                      const std::string &set,
                      const unsigned int body,
                      const unsigned int ply) const;
    /// Writes material and axes of the plies of @p body.
    void
    write_sections(std::ostream &deck, const unsigned int body) const;

    const Scene    &scene;
    CalculixElement element_type;
    Bodies          solids;
    /// First node and element of each body, then one past the last ones.
    std::vector<std::pair<unsigned int, unsigned int>> firsts;
    /// Positions of nodes and nodes of elements, by number minus 1.
    std::vector<dealii::Point<3>>          nodes;
    std::vector<std::vector<unsigned int>> elements;
    /// Index of the ply of each element in its section, from 0 at the bottom.
    std::vector<unsigned int> plies;
  };

  /// Returns @p value as text with 13 digits, in at most 20 characters.
  std::string
  calculix_number(const double value);

  /// Writes the line of a node (number, coordinates) to @p deck.
  void
  write_node(std::ostream           &deck,
             const unsigned int      number,
             const dealii::Point<3> &position);
  /// Writes the number and @p nodes of an element, sixteen entries a line.
  void
  write_element(std::ostream                    &deck,
                const unsigned int               number,
                const std::vector<unsigned int> &nodes);

  /// Writes the line @p keyword and then the numbers in @p set to @p deck.
  void
  write_set(std::ostream                 &deck,
            const std::string            &keyword,
            const std::set<unsigned int> &set);
} // namespace lamella

#endif
