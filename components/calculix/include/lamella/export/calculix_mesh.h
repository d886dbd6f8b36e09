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
   *
   * A cell of the section times an element of the axis is one hexahedron, and
   * it lies in one ply, so plies are element sets with an orientation each:
   * layer-wise, as LE-N is. Where regions are and which points probes have is
   * asked of the solids that Lamella itself makes of the scene, which this
   * owns. The scene is referred to.
   */
  class CalculixMesh
  {
  public:
    /// Makes the solids of @p scene, of the degree of @p element, and numbers
    /// their nodes and cells. Throws InputError where the mesh would have
    /// hanging nodes (Refine near), which a deck cannot hold, and for C3D20R
    /// where a body is a single row of cells.
    CalculixMesh(const Scene &scene, const CalculixElement &element);

    /// Solids, in the order of the scene: what regions, locations and surfaces
    /// are asked of. Cells of theirs are elements here, see element_of().
    const Bodies &
    bodies() const
    {
      return solids;
    }

    /// The one kind of element that all bodies are made of.
    const CalculixElement &
    element() const
    {
      return element_type;
    }

    /// The position of the node @p number, from 1, in the scene's axes.
    const dealii::Point<3> &
    node(const unsigned int number) const
    {
      return nodes[number - 1];
    }

    /// Of all bodies; obstacles' come behind them (CalculixContacts).
    unsigned int
    n_nodes() const
    {
      return nodes.size();
    }

    /// Of all bodies.
    unsigned int
    n_elements() const
    {
      return elements.size();
    }

    /// Numbers of the first node and the first element of @p body (0, 1, ...);
    /// with body = number of bodies one past the last.
    const std::pair<unsigned int, unsigned int> &
    first_of(const unsigned int body) const
    {
      return firsts[body];
    }

    /// The number of the element that is the solid's cell @p cell, as a
    /// Location::Place has it.
    unsigned int
    element_of(const unsigned int body, const unsigned int cell) const
    {
      return firsts[body].second + cell;
    }

    /// The numbers of the nodes of the element @p number, in CalculiX' order.
    const std::vector<unsigned int> &
    nodes_of(const unsigned int number) const
    {
      return elements[number - 1];
    }

    /// The faces that make up @p surface of @p body (bottom, start, ...).
    CalculixFaces
    faces(const unsigned int body, const std::string &surface) const;

    /// The number of the node of @p body at @p location, or 0 if there is none:
    /// no unit coordinates may differ by more than 1e-6 from the node's.
    unsigned int
    node_at(const unsigned int body, const Location &location) const;

    /**
     * The numbers of the nodes on @p region: what stands for it in a support.
     * Throws InputError, of the subsection @p path, if a point is no node, a
     * line runs through elements and not along edges, or there is no such
     * place or surface.
     */
    std::set<unsigned int>
    region_nodes(const Region &region, const std::string &path) const;

    /// The cards of nodes, elements, materials, ply axes and sections, with the
    /// sets BODY1 (nodes) and BODY1_PLY1 (elements), bodies and plies counted
    /// from 1. Materials are isotropic by E and nu where their constants are
    /// so, else orthotropic by nine engineering constants in the ply's axes,
    /// which an orientation turns into the scene's.
    void
    write(std::ostream &deck) const;

  private:
    /// Adds nodes and elements of @p body; nodes that no element of CalculiX
    /// has get no number.
    void
    number(const unsigned int body);
    /// Throws InputError if @p body, the last one numbered, is one hexahedron
    /// wide in two directions: rows of C3D20R hourglass, and nothing holds
    /// them. (Two cells in one of the directions hold each other.)
    void
    refuse_single_row(const unsigned int body) const;
    /// region_nodes() of a line: looked at where it crosses from element to
    /// element and half way between, so on straight edges.
    std::set<unsigned int>
    line_nodes(const Region &region, const std::string &path) const;
    /// MATERIAL1, ..., by rising name in the scene.
    void
    write_materials(std::ostream &deck) const;
    /// Which material and axes the plies of @p body have.
    void
    write_sections(std::ostream &deck, const unsigned int body) const;

    const Scene    &scene;
    CalculixElement element_type;
    Bodies          solids;
    /// Of each body, and one past the last: first node, first element.
    std::vector<std::pair<unsigned int, unsigned int>> firsts;
    /// By number less one.
    std::vector<dealii::Point<3>>          nodes;
    std::vector<std::vector<unsigned int>> elements;
    /// Of each element, number in its section's plies, from 0 at the bottom.
    std::vector<unsigned int> plies;
  };

  /// Numbers as CalculiX reads them, which takes 20 characters: 13 digits with
  /// an exponent.
  std::string
  calculix_number(const double value);

  /// The lines of a node and of an element in a deck: the number, then the
  /// coordinates, or the numbers of the element's nodes (of twenty in two
  /// lines, as CalculiX takes sixteen entries in one).
  void
  write_node(std::ostream           &deck,
             const unsigned int      number,
             const dealii::Point<3> &position);
  void
  write_element(std::ostream                    &deck,
                const unsigned int               number,
                const std::vector<unsigned int> &nodes);

  /// Lines of a deck with the card @p keyword and the numbers of @p set,
  /// sixteen a line at most.
  void
  write_set(std::ostream                 &deck,
            const std::string            &keyword,
            const std::set<unsigned int> &set);
} // namespace lamella

#endif
