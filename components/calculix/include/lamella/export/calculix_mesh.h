// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_export_calculix_mesh_h
#define lamella_export_calculix_mesh_h

#include <lamella/contact/contact_pair.h>
#include <lamella/scene/scene.h>

#include <deal.II/base/point.h>

#include <array>
#include <iosfwd>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
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

  /// Nodal forces at load factor 1 in scene axes, by node number.
  using NodalForces = std::map<unsigned int, dealii::Tensor<1, 3>>;

  /// Supports and loads of a scene as conditions on the nodes of a CalculiX
  /// input deck. Loads become consistent nodal forces f_i = int N_i t dA with
  /// shape functions N_i and traction t. Supports prescribe nodal displacements
  /// along scene axes. A node of two supports is assigned to the first, so that
  /// the sum of reactions is correct. Keeps a reference to the scene.
  class CalculixConditions
  {
  public:
    /// Throws InputError for supports that cannot be prescribed at nodes: lines
    /// and points that are not at nodes, normals oblique to scene axes,
    /// contradictory values; also if only contact constrains a rigid motion.
    CalculixConditions(const Scene &scene, const CalculixMesh &mesh);

    /// Returns the nodes at which support @p s prescribes the displacement
    /// component @p c (0 to 2). Its reaction is the sum of their reactions.
    const std::set<unsigned int> &
    nodes(const unsigned int s, const unsigned int c) const
    {
      return held[s][c];
    }

    /// Returns the sum of applied forces in direction @p c at the nodes of
    /// support @p s, at load factor 1. CalculiX includes it in reactions.
    double
    load_vector_on(const unsigned int s, const unsigned int c) const;

    /// Returns whether the scene has static steps: always, except for natural
    /// modes without loads, contacts and prescribed displacements.
    bool
    has_static_steps() const
    {
      return has_statics;
    }

    /// Returns the number of rigid motions that supports leave free.
    unsigned int
    n_rigid_motions() const
    {
      return n_free_motions;
    }

    /// Returns the node set name of support @p s, component @p c: SUPPORT1_X.
    static std::string
    set_name(const unsigned int s, const unsigned int c);

    /// Writes the node sets to @p deck, one per support and component.
    void
    write_sets(std::ostream &deck) const;

    /// Writes prescribed displacements and nodal forces, times @p factor.
    void
    write_step(std::ostream &deck, const double factor) const;

  private:
    /// Prescribes the displacements of the nodes of the support of index @p s.
    void
    add_support(const unsigned int s, const CalculixMesh &mesh);
    /// Prescribes the displacement @p value for @p component of @p node by
    /// support @p s. Throws InputError if another support contradicts it.
    void
    hold(const unsigned int  node,
         const unsigned int  component,
         const double        value,
         const unsigned int  s,
         const CalculixMesh &mesh);

    const Scene &scene;
    /// Prescribed displacement of each node and component.
    std::map<std::pair<unsigned int, unsigned int>, double> values;
    /// Nodes at which each support prescribes each component.
    std::vector<std::array<std::set<unsigned int>, 3>> held;
    /// Sum of the nodal forces of all loads.
    NodalForces  nodal_forces;
    bool         has_statics    = true;
    unsigned int n_free_motions = 0;
  };

  /// The rigid surface of an obstacle in CalculiX: a layer of 20-node hexahedra
  /// whose faces S2 are on the surface. Node indices begin at 0.
  struct ObstacleLayer
  {
    /// Positions of nodes in scene axes.
    std::vector<dealii::Point<3>> nodes;
    /// Indices of the twenty nodes of each element, in the order of CalculiX.
    std::vector<std::vector<unsigned int>> elements;
    /// Prescribed displacement of all nodes at load factor 1 [length].
    dealii::Tensor<1, 3> displacement;
  };

  /// Returns the elements for the part of the surface of @p obstacle that
  /// contains the points @p facing (not empty), extended on all sides by a
  /// twentieth of its size plus the tangential displacement of the obstacle. A
  /// plane has 8 x 8 elements. Elements of a cylinder span at most 2 degrees;
  /// their parabolic edges deviate from the circle by less than 1e-8 radii.
  ObstacleLayer
  make_layer(const Obstacle                      &obstacle,
             const std::vector<dealii::Point<3>> &facing);

  /// A surface-to-surface contact in CalculiX.
  struct CalculixContact
  {
    /// Name of the contact in the scene.
    std::string   name;
    CalculixFaces slave;  ///< Element faces of the slave surface.
    CalculixFaces master; ///< Element faces of the master surface.
    /// True if the slave surface is the second side of the scene's contact.
    bool slave_is_second = false;
    /// Penalty stiffness: pressure over penetration [force / length^3].
    double stiffness = 0.;
    /// Elements that represent an obstacle; empty for contact of two bodies.
    std::optional<ObstacleLayer> layer;
    unsigned int first_node    = 0; ///< Number of the first node of `layer`.
    unsigned int first_element = 0; ///< Number of its first element.
  };

  /**
   * Contacts of a scene as surface-to-surface contacts of CalculiX with
   * friction. The contact pressure is K times the penetration, even if the
   * scene uses another enforcement of contact.
   *
   * K is the penalty stiffness [force / length^3]. By default it is 100
   * E_n / h of the softer side (normal modulus E_n, smallest depth h of
   * hexahedra at the surface). For a slender body, with a smallest extent d
   * below a tenth of its largest extent L, it is reduced by 10 d / L, since
   * contact iterations of CalculiX may fail otherwise
   * (doc/verification/calculix.md).
   *
   * The slave surface is the one named by `Slave side`, otherwise that with
   * smaller faces on average; in contact with an obstacle it is the body. Nodes
   * and elements of obstacles are numbered after those of the bodies. Keeps a
   * reference to the scene.
   */
  class CalculixContacts
  {
  public:
    /// Creates the contacts of @p scene. @p stiffness, unless empty, replaces
    /// the default penalty stiffness of all contacts. Throws InputError for
    /// `Overclosure = adjust`, for surfaces that a body does not have, and for
    /// surfaces farther from an obstacle than the search radius.
    CalculixContacts(const Scene                 &scene,
                     const CalculixMesh          &mesh,
                     const std::optional<double> &stiffness);

    /// Returns the contacts in the order of the scene.
    const std::vector<CalculixContact> &
    contacts() const
    {
      return list;
    }

    /// Returns the name of the slave surface (@p slave is true) or master
    /// surface (false) of the contact of index @p k, such as CONTACT1_SLAVE.
    static std::string
    surface_name(const unsigned int k, const bool slave);

    /// Writes elements of obstacles, surfaces, contact laws and contact pairs.
    void
    write_model(std::ostream &deck) const;

    /// Writes the displacements of obstacles, times the load factor @p factor.
    void
    write_step(std::ostream &deck, const double factor) const;

    /// Writes the output requests for contact resultants and pressures.
    void
    write_output(std::ostream &deck) const;

  private:
    /// Adds the contact of index @p k in the scene with its default penalty.
    void
    add(const unsigned int k, const CalculixMesh &mesh);
    /// Sets @p layer as master surface of @p contact and numbers its nodes.
    void
    add_layer(ObstacleLayer layer, CalculixContact &contact);
    /// Writes nodes, elements and material of the obstacle of contact @p k.
    void
    write_layer(std::ostream &deck, const unsigned int k) const;

    const Scene &scene;
    /// Contacts in the order of the scene.
    std::vector<CalculixContact> list;
    /// Next free node number and element number.
    unsigned int next_node, next_element;
  };
} // namespace lamella

#endif
