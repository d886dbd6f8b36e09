// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_section_geometry_h
#define lamella_shape_section_geometry_h

#include <lamella/shape/section_mesh.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_q.h>

#include <memory>
#include <vector>

namespace lamella
{
  /**
   * The map x(xi) from the unit square to the cells of a section mesh,
   * interpolated in the nodes of FE_Q<2>(degree) on the mesh's curved edges:
   * what an expansion of that degree calls isoparametric.
   */
  class SectionGeometry
  {
  public:
    SectionGeometry(std::shared_ptr<const SectionMesh> mesh,
                    const unsigned int                 degree);

    const dealii::FE_Q<2> &
    fe() const
    {
      return element;
    }

    /// Positions of all nodes.
    const std::vector<dealii::Point<2>> &
    nodes() const
    {
      return positions;
    }

    unsigned int
    n_cells() const
    {
      return cells.size();
    }

    /// The nodes of @p cell in the order of fe()'s shape functions.
    const std::vector<unsigned int> &
    nodes_of_cell(const unsigned int cell) const
    {
      return cells[cell];
    }

    /// A point and the Jacobian d(x, z) / d(xi, eta) there.
    struct Place
    {
      dealii::Point<2>     position;
      dealii::Tensor<2, 2> jacobian;
    };

    Place
    map(const unsigned int cell, const dealii::Point<2> &unit) const;

  private:
    std::shared_ptr<const SectionMesh>     mesh;
    dealii::FE_Q<2>                        element;
    dealii::DoFHandler<2>                  dof_handler;
    std::vector<dealii::Point<2>>          positions;
    std::vector<std::vector<unsigned int>> cells;
  };

  /// Whether any edge of @p mesh is curved.
  bool
  has_curved_edges(const SectionMesh &mesh);
} // namespace lamella

#endif
