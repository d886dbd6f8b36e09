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
  /// The isoparametric map x(xi) from the unit square to each cell of a section
  /// mesh, with its Jacobian matrix J,
  ///   x(xi) = sum_i N_i(xi) x_i, J = sum_i x_i (x) grad N_i,
  /// with the nodes x_i of FE_Q<2>(degree), which lie on curved edges, and the
  /// Lagrange polynomials N_i at Gauss-Lobatto points. The map is bilinear for
  /// straight-sided cells. For curved cells, the area converges with the degree
  /// (doc/reference/sections.md). Shares ownership of the mesh.
  class SectionGeometry
  {
  public:
    /// Computes the nodes of @p degree >= 1, shared by neighboring cells.
    SectionGeometry(std::shared_ptr<const SectionMesh> mesh,
                    const unsigned int                 degree);

    /// Returns the finite element whose shape functions interpolate positions.
    const dealii::FE_Q<2> &
    fe() const
    {
      return element;
    }

    /// Returns the positions (x, z) of all nodes [length], by node index.
    const std::vector<dealii::Point<2>> &
    nodes() const
    {
      return positions;
    }

    /// Returns the number of cells; indices are those of active cells.
    unsigned int
    n_cells() const
    {
      return cells.size();
    }

    /// Returns the indices of the (degree + 1)^2 nodes of @p cell in the order
    /// of the shape functions of fe(): vertices, edge interiors, cell interior.
    const std::vector<unsigned int> &
    nodes_of_cell(const unsigned int cell) const
    {
      return cells[cell];
    }

    /// A point of a section, mapped from a reference cell.
    struct Place
    {
      dealii::Point<2>     position; ///< Coordinates (x, z) [length].
      dealii::Tensor<2, 2> jacobian; ///< Matrix d(x, z) / d(xi, eta) [length].
    };

    /// Returns the image in @p cell of the point @p unit of the reference cell
    /// [0, 1]^2, or of a point near the reference cell.
    Place
    map(const unsigned int cell, const dealii::Point<2> &unit) const;

  private:
    /// Returns the image of @p unit by the bilinear map to the cell's vertices.
    Place
    bilinear(const unsigned int cell, const dealii::Point<2> &unit) const;

    std::shared_ptr<const SectionMesh>     mesh;
    dealii::FE_Q<2>                        element;
    dealii::DoFHandler<2>                  dof_handler;
    std::vector<dealii::Point<2>>          positions;
    std::vector<std::vector<unsigned int>> cells;
    /// For each cell: true if its map is bilinear, since all its sides are
    /// straight.
    std::vector<bool> is_bilinear;
  };

  /// Returns whether any edge of @p mesh is curved, i.e. its midpoint deviates
  /// from the chord by more than 1e-12 of its length.
  bool
  has_curved_edges(const SectionMesh &mesh);
} // namespace lamella

#endif
