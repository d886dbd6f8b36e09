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

  /// Faces of elements: the element's number and deal.II's of its face.
  using CalculixFaces = std::vector<std::pair<unsigned int, unsigned int>>;

  /**
   * The bodies of a scene as hexahedra of CalculiX, whatever their theories:
   * those that `Theory = solid-2` (or solid-1) makes of them, without the nodes
   * that CalculiX' element does not have. Nodes and elements are numbered from
   * 1, body by body; nodes stand in the scene's axes.
   */
  class CalculixMesh
  {
  public:
    /// Throws InputError where the mesh has hanging nodes.
    CalculixMesh(const Scene &scene, const CalculixElement &element);

    /// Solids: what regions, locations and surfaces are asked of.
    const Bodies &
    bodies() const
    {
      return solids;
    }

    const CalculixElement &
    element() const
    {
      return element_type;
    }

    const dealii::Point<3> &
    node(const unsigned int number) const
    {
      return nodes[number - 1];
    }

    unsigned int
    n_nodes() const
    {
      return nodes.size();
    }

    unsigned int
    n_elements() const
    {
      return elements.size();
    }

    /// Numbers of the first node and the first element of @p body; with
    /// body = number of bodies one past the last.
    const std::pair<unsigned int, unsigned int> &
    first_of(const unsigned int body) const
    {
      return firsts[body];
    }

    unsigned int
    element_of(const unsigned int body, const unsigned int cell) const
    {
      return firsts[body].second + cell;
    }

    /// The nodes of the element @p number in its order.
    const std::vector<unsigned int> &
    nodes_of(const unsigned int number) const
    {
      return elements[number - 1];
    }

    /// The faces that make up @p surface of @p body.
    CalculixFaces
    faces(const unsigned int body, const std::string &surface) const;

    /// The number of the node of @p body at @p location, or 0 if there is none.
    unsigned int
    node_at(const unsigned int body, const Location &location) const;

    /**
     * The nodes on @p region. Throws InputError, beginning with @p what, if a
     * point is no node, or a line runs through elements and not along edges.
     */
    std::set<unsigned int>
    region_nodes(const Region &region, const std::string &what) const;

    /// The cards of nodes, elements, materials, ply axes and sections, with the
    /// sets BODY1 (nodes) and BODY1_PLY1 (elements).
    void
    write(std::ostream &deck) const;

  private:
    void
    number(const unsigned int body);
    std::set<unsigned int>
    line_nodes(const Region &region, const std::string &what) const;
    void
    write_materials(std::ostream &deck) const;
    void
    write_sections(std::ostream &deck, const unsigned int body) const;

    const Scene                                       &scene;
    CalculixElement                                    element_type;
    Bodies                                             solids;
    std::vector<std::pair<unsigned int, unsigned int>> firsts;
    std::vector<dealii::Point<3>>                      nodes;
    std::vector<std::vector<unsigned int>>             elements;
    /// Of each element, number in its section's plies.
    std::vector<unsigned int> plies;
  };

  /// Numbers as CalculiX reads them: it takes 20 characters.
  std::string
  calculix_number(const double value);

  /// The lines of a node and of an element in a deck.
  void
  write_node(std::ostream           &deck,
             const unsigned int      number,
             const dealii::Point<3> &position);
  void
  write_element(std::ostream                    &deck,
                const unsigned int               number,
                const std::vector<unsigned int> &nodes);

  /// Lines of a deck with the numbers of @p set, sixteen a line at most.
  void
  write_set(std::ostream                 &deck,
            const std::string            &keyword,
            const std::set<unsigned int> &set);
} // namespace lamella

#endif
