// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_lagrange_element_h
#define lamella_section_lagrange_element_h

#include <lamella/section/cross_section_element.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_q.h>

namespace lamella
{
  /**
   * The Lagrange expansion LE-p (Eq. 3): deal.II's FE_Q<2>(p) on the section
   * mesh, so L4, L9 and L16 for p = 1, 2, 3 (the nodes of p >= 3 are the
   * Gauss-Lobatto points; the space is that of equidistant nodes).
   *
   * The nodal functions of three nodes not on a line give way to 1,
   * (x - x_c)/h, (z - z_c)/h; the other nodal functions stay as warping. The
   * geometry is interpolated in the same nodes (isoparametric), so x and z are
   * in the span of the nodal functions and the space is exactly that of LE.
   */
  class LagrangeElement : public CrossSectionElement
  {
  public:
    /// @p degree from 1.
    LagrangeElement(std::shared_ptr<const SectionMesh> mesh,
                    const unsigned int                 degree);

    std::string
    name() const override;

    unsigned int
    degree() const override
    {
      return fe.degree;
    }

    unsigned int
    n_functions() const override
    {
      return 3 + dof_handler.n_dofs() - 3;
    }

    const std::vector<unsigned int> &
    cell_functions(const unsigned int cell) const override
    {
      return cells[cell].functions;
    }

    FunctionValues
    evaluate(const unsigned int      cell,
             const dealii::Point<2> &unit) const override;

    std::vector<EdgePoint>
    edge_points(const std::string &boundary) const override;

    std::vector<EdgePoint>
    section_points() const override;

  private:
    struct Cell
    {
      std::vector<dealii::types::global_dof_index> nodes;
      /// Local numbers of the nodes whose functions are kept as warping.
      std::vector<unsigned int> warping;
      /// 0, 1, 2 and then the functions of the warping nodes, ascending.
      std::vector<unsigned int> functions;
    };

    /// The three nodes that give way: two far apart and a third far off their
    /// line.
    std::array<unsigned int, 3>
    replaced_nodes() const;

    void
    number_functions();

    /// Position and Jacobian at @p unit from the nodes of @p cell.
    void
    map_geometry(const unsigned int      cell,
                 const dealii::Point<2> &unit,
                 FunctionValues         &result) const;

    dealii::FE_Q<2>               fe;
    dealii::DoFHandler<2>         dof_handler;
    std::vector<dealii::Point<2>> nodes;
    std::vector<Cell>             cells;
  };
} // namespace lamella

#endif
