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
   *
   * On a mesh with cells in each ply that is the layer-wise (LW) expansion: u
   * is continuous, its derivatives may jump at ply interfaces, so transverse
   * strains do and transverse stresses need not.
   *
   * n_functions() is the number of the mesh's nodes; (p + 1)^2 functions of
   * these live on a cell, besides the three linear ones and, in columns, two a
   * column.
   */
  class LagrangeElement : public CrossSectionElement
  {
  public:
    /// The ratio of width and height from which grids are built in columns:
    /// below it the columns only cost (their functions couple with more). Of
    /// the width over the height, or the other way round.
    static constexpr double usual_column_aspect = 100.;

    /// @p degree p from 1. @p column_aspect is the ratio of the long to the
    /// short side of a rectangular grid from which on it is built in columns.
    /// Shares @p mesh.
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

    /// 0 for 1, x, z; 1 for warping, in a grid of columns for the functions of
    /// whole columns, whose other nodal functions are of level 2.
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

    /// Values below 1e-14 become 0, so that rows at nodes are short.
    FunctionValues
    evaluate(const unsigned int      cell,
             const dealii::Point<2> &unit) const override;

    SectionGeometry::Place
    map(const unsigned int cell, const dealii::Point<2> &unit) const override
    {
      return geometry.map(cell, unit);
    }

    /// The nodes on it; normals and weights are integrals of the nodal
    /// functions along the sides.
    std::vector<EdgePoint>
    edge_points(const std::string &boundary) const override;

    /// The nodes.
    std::vector<EdgePoint>
    section_points() const override
    {
      return section_grid();
    }

    /// The nodes, with the integrals of the nodal functions for weights.
    /// [length^2]
    std::vector<EdgePoint>
    section_grid() const override;

  private:
    /**
     * A function that does not vanish on a cell: the sum of the nodal
     * functions of @p nodes (local numbers) times 1 or, as a slope, the
     * coordinate along the column.
     *   nodal         N_i
     *   column        G = sum N_i over the column's nodes on the cell
     *   column_slope  G (z - z_c) / h_z
     * (z the coordinate along the column). Derivatives of the last two across
     * the column are those of the nodal functions; along it that of G is zero
     * and not a sum of what cancels.
     */
    struct LocalFunction
    {
      enum class Kind
      {
        nodal,
        column,
        column_slope
      };
      /// Of the function in the whole section.
      unsigned int              number;
      Kind                      kind;
      std::vector<unsigned int> nodes;
    };

    /// What a cell evaluates, in the order of its numbers.
    struct Cell
    {
      /// 0, 1, 2 and those of functions, ascending.
      std::vector<unsigned int>  numbers;
      std::vector<LocalFunction> functions;
    };

    /// A grid of nodes: for each its place along the long side of the section
    /// and along the short one. Both counted from 0 in ascending coordinates.
    /// n_columns is 0 if there is none.
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
    /// they are none or the section is not slender. They are a grid if as many
    /// distinct x times as many distinct z are as many as there are nodes.
    Grid
    find_grid(const double column_aspect) const;

    /// Numbers for the basis of the general case: 0, 1, 2 and a node each.
    void
    number_nodal_functions();

    /// Numbers for the basis in columns. 1, x, z stand for both functions of
    /// the first column and the constant one of the last.
    void
    number_column_functions(const Grid &grid);

    /// Sorts the functions of each cell and lists their numbers.
    void
    collect_numbers();

    /// The isoparametric map in the expansion's own nodes.
    SectionGeometry geometry;
    /// Of each function its level(); of each cell its functions.
    std::vector<unsigned int> levels;
    std::vector<Cell>         cells;
    /// Of a grid: 0 if the section is wide, 1 if it is high; and the length
    /// that makes the coordinate along a column dimensionless.
    unsigned int long_side     = 0;
    double       column_length = 1.;
  };
} // namespace lamella

#endif
