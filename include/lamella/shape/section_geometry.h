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
   *
   *   x(xi) = sum_i N_i(xi) x_i, J = sum_i x_i (x) grad N_i,
   *
   * with the nodes x_i on the arcs themselves and the N_i Lagrange polynomials
   * at Gauss-Lobatto points. Straight-sided cells are bilinear whatever the
   * degree; on curved ones the area converges with the degree
   * (doc/sections.md). The mesh is shared, and kept alive, by this object.
   */
  class SectionGeometry
  {
  public:
    /// Distributes the nodes of @p degree >= 1 on all cells; nodes on common
    /// sides are one.
    SectionGeometry(std::shared_ptr<const SectionMesh> mesh,
                    const unsigned int                 degree);

    /// The element on the unit square whose shape functions are the N_i.
    const dealii::FE_Q<2> &
    fe() const
    {
      return element;
    }

    /// Positions (x, z) of all nodes [length], in the numbers that
    /// nodes_of_cell() gives.
    const std::vector<dealii::Point<2>> &
    nodes() const
    {
      return positions;
    }

    /// Cells are numbered as active cells of the mesh are.
    unsigned int
    n_cells() const
    {
      return cells.size();
    }

    /// The nodes of @p cell in the order of fe()'s shape functions. (degree +
    /// 1)^2 of them: four vertices, then nodes inside edges, then inside, which
    /// is deal.II's order of FE_Q.
    const std::vector<unsigned int> &
    nodes_of_cell(const unsigned int cell) const
    {
      return cells[cell];
    }

    /// A point and the Jacobian d(x, z) / d(xi, eta) there. The determinant of
    /// the Jacobian is the area per unit of the square.
    struct Place
    {
      dealii::Point<2>     position;
      dealii::Tensor<2, 2> jacobian;
    };

    /// @p unit in [0, 1]^2 or outside of it, where the polynomial goes on.
    /// Costs (degree + 1)^2 evaluations of shape functions, of a cell whose
    /// sides are straight four; tables are for those who integrate.
    Place
    map(const unsigned int cell, const dealii::Point<2> &unit) const;

  private:
    /// map() by the vertices of @p cell alone.
    Place
    bilinear(const unsigned int cell, const dealii::Point<2> &unit) const;

    std::shared_ptr<const SectionMesh>     mesh;
    dealii::FE_Q<2>                        element;
    dealii::DoFHandler<2>                  dof_handler;
    std::vector<dealii::Point<2>>          positions;
    std::vector<std::vector<unsigned int>> cells;
    /// Of each cell: whether its nodes are where its vertices alone put them.
    std::vector<bool> is_bilinear;
  };

  /// Whether any edge of @p mesh is curved. It is if its middle is off the
  /// chord by more than 1e-12 of its length. Geometry without curved edges is
  /// bilinear, and needs neither a higher degree nor more points to integrate.
  bool
  has_curved_edges(const SectionMesh &mesh);
} // namespace lamella

#endif
