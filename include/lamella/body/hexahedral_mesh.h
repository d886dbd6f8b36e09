// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_hexahedral_mesh_h
#define lamella_body_hexahedral_mesh_h

#include <lamella/axis/axis.h>
#include <lamella/shape/section_mesh.h>

#include <deal.II/base/point.h>

#include <deal.II/distributed/tria.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Mesh refinement of a solid, by dividing hexahedra into eight.
  struct SolidRefinement
  {
    /// Number of refinements of all hexahedra, each into eight.
    unsigned int everywhere = 0;
    /// Further refinements of all hexahedra that intersect or touch a ball.
    struct Ball
    {
      dealii::Point<3> center;      ///< Center of the ball.
      double           radius = 0.; ///< Radius of the ball [length].
      unsigned int     times  = 0;  ///< Number of refinements.
    };
    std::vector<Ball> balls; ///< Balls for local refinement; may be empty.
    /// Memory limit of the mesh [bytes]; 0: the memory of the machine.
    double memory_limit = 0.;
  };

  /// The hexahedral mesh of a solid in body axes: a section mesh extruded along
  /// the axis, on deal.II's parallel::distributed::Triangulation, with the
  /// nodes of FE_Q<3>(degree), numbered process by process. Each process stores
  /// all cells, nodes and boundary faces. Nodes are on the curved edges of the
  /// section unless the constraints of hanging nodes move them.
  class HexahedralMesh
  {
  public:
    /// Value of Cell::sides for faces in the interior of the body.
    static constexpr int inside = -1;

    /// A hexahedron of the mesh.
    struct Cell
    {
      unsigned int ply = 0; ///< Index of its ply in the section mesh.
      /// Indices of its nodes, in the order of the shape functions of FE_Q.
      std::vector<unsigned int> nodes;
      /// Index in sides() of each face's surface (deal.II's order), or
      /// `inside`.
      std::array<int, 6> sides;

      /// Serializes all members (Boost.Serialization).
      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &ply &nodes &sides;
      }
    };

    /// A hanging node, whose value is a weighted sum of values of other nodes.
    struct HangingNode
    {
      unsigned int node = 0; ///< Index of the hanging node.
      /// Indices of the nodes in the sum, with their weights.
      std::vector<std::pair<unsigned int, double>> masters;
    };

    /// Constructs the mesh; balls are in body axes. Throws InputError, whose
    /// text begins with @p what, if the section mesh has hanging nodes, a ball
    /// intersects no hexahedron, or the memory is not sufficient.
    HexahedralMesh(std::shared_ptr<const SectionMesh> section,
                   const AxisMesh                    &axis,
                   const unsigned int                 degree,
                   const SolidRefinement             &refinement,
                   const std::string                 &what);

    /// Returns the section mesh that is extruded.
    const SectionMesh &
    section() const
    {
      return *section_mesh;
    }

    /// Returns all hexahedra of the body, on every process.
    const std::vector<Cell> &
    cells() const
    {
      return all_cells;
    }

    /// Returns the indices of this process's first cell and one past its last.
    std::pair<unsigned int, unsigned int>
    owned_cells() const
    {
      return own_cells;
    }

    /// Returns the positions of all nodes, body axes.
    const std::vector<dealii::Point<3>> &
    nodes() const
    {
      return positions;
    }

    /// Returns the indices of this process's first node and one past its last.
    std::pair<unsigned int, unsigned int>
    owned_nodes() const
    {
      return own_nodes;
    }

    /// Returns the hanging nodes; empty without local refinement.
    const std::vector<HangingNode> &
    hanging_nodes() const
    {
      return hanging;
    }

    /// Returns the names of the surfaces: section boundaries, `start`, `end`.
    const std::vector<std::string> &
    sides() const
    {
      return side_names;
    }

  private:
    void
    extrude(const AxisMesh &axis, const std::string &what);
    void
    curve();
    void
    refine(const SolidRefinement &refinement,
           const unsigned int     degree,
           const std::string     &what);
    void
    gather(const unsigned int degree);

    std::shared_ptr<const SectionMesh>              section_mesh;
    dealii::parallel::distributed::Triangulation<3> mesh;

    std::vector<std::string>              side_names;
    std::vector<Cell>                     all_cells;
    std::vector<dealii::Point<3>>         positions;
    std::vector<HangingNode>              hanging;
    std::pair<unsigned int, unsigned int> own_cells, own_nodes;
  };
} // namespace lamella

#endif
