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
  /// The isoparametric map from the unit square to the cells of a section mesh,
  /// by FE_Q<2>(degree) nodes x_i on the mesh's curved edges,
  ///   x(xi) = sum_i N_i(xi) x_i, J = sum_i x_i (x) grad N_i,
  /// with Lagrange polynomials N_i at Gauss-Lobatto points. Cells with straight
  /// sides are bilinear; the area of curved ones converges with the degree
  /// (doc/reference/sections.md). Shares ownership of the mesh.
  class SectionGeometry
  {
  public:
    /// Distributes the nodes of @p degree >= 1; common sides share nodes.
    SectionGeometry(std::shared_ptr<const SectionMesh> mesh,
                    const unsigned int                 degree);

    /// Returns the element on the unit square with shape functions N_i.
    const dealii::FE_Q<2> &
    fe() const
    {
      return element;
    }

    /// Returns the positions (x, z) of all nodes [length] (nodes_of_cell()).
    const std::vector<dealii::Point<2>> &
    nodes() const
    {
      return positions;
    }

    /// Returns the number of cells, numbered as active cells of the mesh.
    unsigned int
    n_cells() const
    {
      return cells.size();
    }

    /// Returns the (degree + 1)^2 nodes of @p cell in the order of fe()'s shape
    /// functions: vertices, edge interiors, interior.
    const std::vector<unsigned int> &
    nodes_of_cell(const unsigned int cell) const
    {
      return cells[cell];
    }

    /// A point and the Jacobian d(x, z) / d(xi, eta).
    struct Place
    {
      dealii::Point<2>     position;
      dealii::Tensor<2, 2> jacobian;
    };

    /// Maps @p unit, in [0, 1]^2 or extrapolated.
    Place
    map(const unsigned int cell, const dealii::Point<2> &unit) const;

  private:
    /// Maps by the vertices of @p cell alone.
    Place
    bilinear(const unsigned int cell, const dealii::Point<2> &unit) const;

    std::shared_ptr<const SectionMesh>     mesh;
    dealii::FE_Q<2>                        element;
    dealii::DoFHandler<2>                  dof_handler;
    std::vector<dealii::Point<2>>          positions;
    std::vector<std::vector<unsigned int>> cells;
    /// Cells whose nodes are at their bilinear positions.
    std::vector<bool> is_bilinear;
  };

  /// Returns whether any edge of @p mesh is curved: its middle is off the chord
  /// by more than 1e-12 of its length.
  bool
  has_curved_edges(const SectionMesh &mesh);
} // namespace lamella

#endif
