// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/shape/section_geometry.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/mapping_q.h>

namespace lamella
{
  using namespace dealii;

  SectionGeometry::SectionGeometry(std::shared_ptr<const SectionMesh> mesh_,
                                   const unsigned int                 degree)
    : mesh(std::move(mesh_))
    , element(degree)
    , dof_handler(mesh->mesh)
  {
    dof_handler.distribute_dofs(element);
    positions.resize(dof_handler.n_dofs());
    DoFTools::map_dofs_to_support_points(MappingQ<2>(degree),
                                         dof_handler,
                                         positions);
    std::vector<types::global_dof_index> indices(element.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(indices);
        cells.emplace_back(indices.begin(), indices.end());
        is_bilinear.push_back(true);
        for (unsigned int i = 0; i < indices.size(); ++i)
          if (positions[indices[i]].distance(
                bilinear(cells.size() - 1, element.unit_support_point(i))
                  .position) > arithmetic::rounding * cell->diameter())
            is_bilinear.back() = false;
      }
  }



  SectionGeometry::Place
  SectionGeometry::bilinear(const unsigned int cell, const Point<2> &unit) const
  {
    Place place;
    // The first nodes of FE_Q are the vertices.
    for (const unsigned int v : GeometryInfo<2>::vertex_indices())
      {
        const Point<2> &node = positions[cells[cell][v]];
        place.position +=
          GeometryInfo<2>::d_linear_shape_function(unit, v) * node;
        place.jacobian +=
          outer_product(Tensor<1, 2>(node),
                        GeometryInfo<2>::d_linear_shape_function_gradient(unit,
                                                                          v));
      }
    return place;
  }



  SectionGeometry::Place
  SectionGeometry::map(const unsigned int cell, const Point<2> &unit) const
  {
    if (is_bilinear[cell])
      return bilinear(cell, unit);
    Place place;
    for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
      {
        const Point<2> &node = positions[cells[cell][i]];
        place.position += element.shape_value(i, unit) * node;
        place.jacobian +=
          outer_product(Tensor<1, 2>(node), element.shape_grad(i, unit));
      }
    return place;
  }



  bool
  has_curved_edges(const SectionMesh &mesh)
  {
    for (const auto &cell : mesh.mesh.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        {
          const auto     face = cell->face(f);
          const Point<2> chord =
            face->vertex(0) + 0.5 * (face->vertex(1) - face->vertex(0));
          if (face->center(/*respect_manifold=*/true).distance(chord) >
              arithmetic::rounding_of_results * face->diameter())
            return true;
        }
    return false;
  }
} // namespace lamella
