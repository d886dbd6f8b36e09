// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/memory.h>
#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/body/hexahedral_mesh.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold.h>

#include <boost/serialization/utility.hpp>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// A curve of the section swept along the axis: its x, z; the mean y.
    class SweptManifold : public Manifold<3, 3>
    {
    public:
      explicit SweptManifold(const Manifold<2, 2> &in_section)
        : in_section(in_section.clone())
      {}

      std::unique_ptr<Manifold<3, 3>>
      clone() const override
      {
        return std::make_unique<SweptManifold>(*in_section);
      }

      Point<3>
      get_new_point(const ArrayView<const Point<3>> &points,
                    const ArrayView<const double>   &weights) const override
      {
        // The section may not take points above each other twice.
        std::vector<Point<2>> places;
        std::vector<double>   shares;
        double                y = 0.;
        for (unsigned int k = 0; k < points.size(); ++k)
          {
            const Point<2> x(points[k][0], points[k][2]);
            y += weights[k] * points[k][1];
            unsigned int p = 0;
            while (p < places.size() &&
                   places[p].distance(x) >
                     arithmetic::rounding_of_results *
                       (arithmetic::smallest_divisor + x.norm()))
              ++p;
            if (p == places.size())
              {
                places.push_back(x);
                shares.push_back(0.);
              }
            shares[p] += weights[k];
          }
        const Point<2> x = places.size() == 1 ?
                             places[0] :
                             in_section->get_new_point(make_array_view(places),
                                                       make_array_view(shares));
        return {x[0], y, x[1]};
      }

    private:
      std::unique_ptr<const Manifold<2, 2>> in_section;
    };



    /// The faces of a hexahedron that the edges of a section's cell sweep, in
    /// the order of the edges. Faces 2 and 3 lie in planes of the section.
    constexpr std::array<unsigned int, 4> swept_face{{0, 1, 4, 5}};



    /// Throws InputError if @p n_cells hexahedra cannot fit in memory.
    void
    require_memory(const double       n_cells,
                   const unsigned int degree,
                   const double       limit,
                   const std::string &what)
    {
      // Far below what there is inside of a mesh, nodes at its surface have
      // less: a node for the first, eight for the second degree in each cell,
      // rows of 40 and 100 entries with all that is kept of each.
      const double dofs    = 3. * (degree == 1 ? 1. : 8.) * n_cells;
      const double matrix  = dofs * (degree == 1 ? 40. : 100.) * 24.;
      const double cells   = 1000. * n_cells;
      const double needed  = (matrix + cells) / n_processes();
      const double allowed = available_memory(limit);
      if (sum_over_machine(needed) > allowed)
        throw InputError(
          what,
          "",
          "body.too-large: the body has " + to_text(n_cells, 3) +
            " hexahedra after its refinement, about " + to_text(dofs, 2) +
            " DoFs, and needs more memory than " + gigabytes(matrix + cells) +
            ", and " + gigabytes(allowed) + " are available on each machine",
          "Reduce Refinements, or refine near a point only (Refine near).");
    }



    /// Flags cells of @p mesh in @p ball; returns their global number.
    unsigned int
    flag_cells(parallel::distributed::Triangulation<3> &mesh,
               const SolidRefinement::Ball             &ball)
    {
      unsigned int flagged = 0;
      for (const auto &cell : mesh.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            const BoundingBox<3> box     = cell->bounding_box();
            Point<3>             nearest = ball.center;
            for (unsigned int d = 0; d < 3; ++d)
              nearest[d] = std::min(box.upper_bound(d),
                                    std::max(box.lower_bound(d), nearest[d]));
            if (nearest.distance(ball.center) < ball.radius)
              {
                cell->set_refine_flag();
                ++flagged;
              }
          }
      return Utilities::MPI::sum(flagged, communicator());
    }



    /// The cells of this process.
    std::vector<HexahedralMesh::Cell>
    own_part(const DoFHandler<3> &dof_handler)
    {
      std::vector<types::global_dof_index> nodes(
        dof_handler.get_fe().n_dofs_per_cell());
      std::vector<HexahedralMesh::Cell> cells;
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            cells.emplace_back();
            cells.back().ply = cell->material_id();
            cell->get_dof_indices(nodes);
            cells.back().nodes.assign(nodes.begin(), nodes.end());
            for (const unsigned int f : cell->face_indices())
              cells.back().sides[f] = cell->face(f)->at_boundary() ?
                                        int(cell->face(f)->boundary_id()) :
                                        HexahedralMesh::inside;
          }
      return cells;
    }



    /// The places of this process's nodes, in their order.
    std::vector<Point<3>>
    own_positions(const DoFHandler<3> &dof_handler)
    {
      std::map<types::global_dof_index, Point<3>> places;
      DoFTools::map_dofs_to_support_points(
        MappingQ<3>(dof_handler.get_fe().degree), dof_handler, places);
      std::vector<Point<3>> positions;
      for (const auto node : dof_handler.locally_owned_dofs())
        positions.push_back(places.at(node));
      return positions;
    }



    /// Puts the parts of all processes one after the other into @p all; numbers
    /// there of the first of @p own, and of the first beyond it.
    template <typename T>
    std::pair<unsigned int, unsigned int>
    gather_in_order(const std::vector<T> &own, std::vector<T> &all)
    {
      std::pair<unsigned int, unsigned int> range;
      const auto parts = Utilities::MPI::all_gather(communicator(), own);
      for (unsigned int p = 0; p < parts.size(); ++p)
        {
          if (p == this_process())
            range = {all.size(), all.size() + own.size()};
          all.insert(all.end(), parts[p].begin(), parts[p].end());
        }
      return range;
    }



    using HangingLine =
      std::pair<unsigned int, std::vector<std::pair<unsigned int, double>>>;

    /// The constraints of this process's hanging nodes.
    std::vector<HangingLine>
    hanging_lines(const DoFHandler<3> &dof_handler)
    {
      IndexSet relevant;
      DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
      Constraints constraints(relevant);
      DoFTools::make_hanging_node_constraints(dof_handler, constraints);
      constraints.close();
      std::vector<HangingLine> lines;
      for (const auto node : dof_handler.locally_owned_dofs())
        if (constraints.is_constrained(node))
          {
            lines.emplace_back(node, 0);
            for (const auto &[master, weight] :
                 *constraints.get_constraint_entries(node))
              lines.back().second.emplace_back(master, weight);
          }
      return lines;
    }
  } // namespace



  HexahedralMesh::HexahedralMesh(std::shared_ptr<const SectionMesh> section,
                                 const AxisMesh                    &axis,
                                 const unsigned int                 degree,
                                 const SolidRefinement             &refinement,
                                 const std::string                 &what)
    : section_mesh(std::move(section))
    , mesh(communicator())
  {
    extrude(axis, what);
    curve();
    refine(refinement, degree, what);
    gather(degree);
  }



  void
  HexahedralMesh::extrude(const AxisMesh &axis, const std::string &what)
  {
    const Triangulation<2> &plane = section_mesh->mesh;
    if (plane.has_hanging_nodes())
      throw InputError(
        what,
        "",
        "body.hanging-nodes: the mesh of the section has hanging nodes, so its "
        "extrusion along the axis is no conforming mesh of hexahedra",
        "Use a mesh of the section without hanging nodes.");
    std::vector<double> y{0.};
    for (const double length : element_lengths(axis))
      y.push_back(y.back() + length);
    y.back() = axis.length;

    const unsigned int    n = plane.n_vertices();
    std::vector<Point<3>> vertices;
    for (const double at : y)
      for (const Point<2> &v : plane.get_vertices())
        vertices.emplace_back(v[0], at, v[1]);
    std::vector<CellData<3>> hexahedra;
    for (unsigned int j = 0; j + 1 < y.size(); ++j)
      for (const auto &cell : plane.active_cell_iterators())
        {
          hexahedra.emplace_back();
          hexahedra.back().material_id = cell->material_id();
          for (unsigned int v = 0; v < 8; ++v)
            hexahedra.back().vertices[v] =
              (j + v / 2 % 2) * n + cell->vertex_index(v % 2 + 2 * (v / 4));
        }
    SubCellData none;
    GridTools::delete_unused_vertices(vertices, hexahedra, none);
    mesh.create_triangulation(vertices, hexahedra, none);
  }



  void
  HexahedralMesh::curve()
  {
    const Triangulation<2> &plane = section_mesh->mesh;
    // Boundary ids are numbers in side_names.
    std::map<types::boundary_id, unsigned int> number;
    for (const auto &[id, name] : section_mesh->boundaries)
      {
        number[id] = side_names.size();
        side_names.push_back(name);
      }
    const unsigned int start = side_names.size(), end = start + 1;
    side_names.insert(side_names.end(), {"start", "end"});

    for (const types::manifold_id id : plane.get_manifold_ids())
      if (id != numbers::flat_manifold_id)
        mesh.set_manifold(id, SweptManifold(plane.get_manifold(id)));

    mesh.set_all_manifold_ids(numbers::flat_manifold_id);
    auto hexahedron = mesh.begin(0);
    while (hexahedron != mesh.end(0))
      for (const auto &cell : plane.active_cell_iterators())
        {
          hexahedron->set_manifold_id(cell->manifold_id());
          for (const unsigned int f : cell->face_indices())
            {
              const auto face = hexahedron->face(swept_face[f]);
              if (cell->face(f)->at_boundary())
                face->set_boundary_id(number.at(cell->face(f)->boundary_id()));
              if (cell->face(f)->manifold_id() != numbers::flat_manifold_id)
                face->set_all_manifold_ids(cell->face(f)->manifold_id());
            }
          for (const unsigned int f : {2, 3})
            {
              hexahedron->face(f)->set_manifold_id(cell->manifold_id());
              if (hexahedron->face(f)->at_boundary())
                hexahedron->face(f)->set_boundary_id(f == 2 ? start : end);
            }
          ++hexahedron;
        }
  }



  void
  HexahedralMesh::refine(const SolidRefinement &refinement,
                         const unsigned int     degree,
                         const std::string     &what)
  {
    const auto require = [&](const double n_cells) {
      require_memory(n_cells, degree, refinement.memory_limit, what);
    };
    require(mesh.n_global_active_cells() * std::pow(8., refinement.everywhere));
    mesh.refine_global(refinement.everywhere);
    for (const SolidRefinement::Ball &ball : refinement.balls)
      for (unsigned int k = 0; k < ball.times; ++k)
        {
          const unsigned int flagged = flag_cells(mesh, ball);
          if (flagged == 0)
            throw InputError(
              what + "/Kinematics/Refine near",
              "",
              "body.ball-outside: no cell intersects the ball of radius " +
                to_text(ball.radius),
              "Write a center in scene coordinates, inside or near the body.");
          require(mesh.n_global_active_cells() + 7. * flagged);
          mesh.execute_coarsening_and_refinement();
        }
  }



  void
  HexahedralMesh::gather(const unsigned int degree)
  {
    // These are for numbering only: a DoFHandler kept would know the cells of
    // this process alone, where Hexahedron maps any that is in the directory.
    const FE_Q<3> fe(degree);
    DoFHandler<3> dof_handler(mesh);
    dof_handler.distribute_dofs(fe);

    own_cells = gather_in_order(own_part(dof_handler), all_cells);
    own_nodes = gather_in_order(own_positions(dof_handler), positions);
    for (const auto &lines :
         Utilities::MPI::all_gather(communicator(), hanging_lines(dof_handler)))
      for (const auto &[node, masters] : lines)
        {
          hanging.push_back({node, masters});
          Point<3> x;
          for (const auto &[master, weight] : masters)
            x += weight * positions[master];
          positions[node] = x;
        }
  }
} // namespace lamella
