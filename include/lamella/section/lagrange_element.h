// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_lagrange_element_h
#define lamella_section_lagrange_element_h

#include <lamella/section/cross_section_element.h>
#include <lamella/shape/section_geometry.h>

namespace lamella
{
  /**
   * The Lagrange expansion LE-p (Eq. 3): deal.II's FE_Q<2>(p) on the section
   * mesh, so L4, L9 and L16 for p = 1, 2, 3 (the nodes of p >= 3 are the
   * Gauss-Lobatto points; the space is that of equidistant nodes). The geometry
   * is interpolated in the same nodes (isoparametric), so x and z are in the
   * span of the nodal functions, and each basis below spans exactly LE.
   *
   * In general the nodal functions of three nodes not on a line give way to 1,
   * (x - x_c)/h, (z - z_c)/h; the other nodal functions stay as warping.
   *
   * On a rectangular grid that is much wider than high the same loss of digits
   * threatens across the width as along the axis. There the basis is built in
   * columns: with G_i(x) the sum of the nodal functions of the column at x_i,
   * two nodes of each column give way to G_i and G_i (z - z_c) / h_z,
   * differentiated analytically in z, and three of these to 1, x, z. (On one
   * that is much higher than wide x and z change places.)
   */
  class LagrangeElement : public CrossSectionElement
  {
  public:
    /// The ratio of width and height from which grids are built in columns:
    /// below it the columns only cost (their functions couple with more).
    static constexpr double usual_column_aspect = 100.;

    /// @p degree from 1.
    LagrangeElement(std::shared_ptr<const SectionMesh> mesh,
                    const unsigned int                 degree,
                    const double column_aspect = usual_column_aspect);

    unsigned int
    degree() const override
    {
      return geometry.fe().degree;
    }

    unsigned int
    n_functions() const override
    {
      return levels.size();
    }

    unsigned int
    level(const unsigned int tau) const override
    {
      return levels[tau];
    }

    const std::vector<unsigned int> &
    cell_functions(const unsigned int cell) const override
    {
      return cells[cell].numbers;
    }

    FunctionValues
    evaluate(const unsigned int      cell,
             const dealii::Point<2> &unit) const override;

    SectionGeometry::Place
    map(const unsigned int cell, const dealii::Point<2> &unit) const override
    {
      return geometry.map(cell, unit);
    }

    std::vector<EdgePoint>
    edge_points(const std::string &boundary) const override;

    /// The nodes.
    std::vector<EdgePoint>
    section_points() const override
    {
      return section_grid();
    }

    std::vector<EdgePoint>
    section_grid() const override;

  private:
    /// A function that does not vanish on a cell: the sum of the nodal
    /// functions of @p nodes (local numbers) times 1 or, as a slope, the
    /// coordinate along the column.
    struct LocalFunction
    {
      enum class Kind
      {
        nodal,
        column,
        column_slope
      };
      unsigned int              number;
      Kind                      kind;
      std::vector<unsigned int> nodes;
    };

    struct Cell
    {
      /// 0, 1, 2 and those of functions, ascending.
      std::vector<unsigned int>  numbers;
      std::vector<LocalFunction> functions;
    };

    /// A grid of nodes: for each its place along the long side of the section
    /// and along the short one.
    struct Grid
    {
      std::vector<unsigned int> column, place;
      unsigned int              n_columns = 0, n_places = 0;
    };

    /// The three nodes that give way: two far apart and a third far off their
    /// line.
    std::array<unsigned int, 3>
    replaced_nodes() const;

    /// The nodes as a grid of columns across the direction long_side, empty if
    /// they are none or the section is not slender.
    Grid
    find_grid(const double column_aspect) const;

    void
    number_nodal_functions();

    void
    number_column_functions(const Grid &grid);

    void
    collect_numbers();

    SectionGeometry           geometry;
    std::vector<unsigned int> levels;
    std::vector<Cell>         cells;
    /// Of a grid: 0 if the section is wide, 1 if it is high; and the length
    /// that makes the coordinate along a column dimensionless.
    unsigned int long_side     = 0;
    double       column_length = 1.;
  };
} // namespace lamella

#endif
