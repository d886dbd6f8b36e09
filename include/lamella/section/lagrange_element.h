// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_lagrange_element_h
#define lamella_section_lagrange_element_h

#include <lamella/section/cross_section_element.h>
#include <lamella/shape/section_geometry.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

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
   * Both are bases of LE-p alone. Where nodes of one beam are to carry LE-1,
   * LE-2, ... the basis is *hierarchical* by degree, as that of deal.II's
   * FE_Q_Hierarchical: the bilinear functions of the vertices, and products
   *   l_i(xi) l_j(eta),   max(i, j) = 2, 3, ..., p,
   *   l_0 = 1 - t,  l_1 = t,
   *   l_k = int_(-1)^(2t-1) P_(k-1) / |P_(k-1)| ds   for k > 1
   * (integrated Legendre polynomials, Szabo and Babuska 1991, which vanish at
   * both ends), on edges where one of i, j is below 2, else inside of a cell.
   * Odd ones on an edge change sign with its direction, which is from the
   * vertex of the smaller number to the other, whatever cells make of it. Three
   * vertices give way to 1, x, z. Functions are numbered degree after degree:
   * the leading ones up to degree q span LE-q, so that LE-1 < LE-2 < ... are
   * parts of one space and share one set of S_pq.
   *
   * (Not so always: it wins nothing for a body of one LE-p, whose factor and
   * rows of contact fill by some per cent more, and condition numbers double;
   * doc/theories.md has numbers. Columns have no like of it yet.)
   *
   * On curved cells the map is that of degree p for all functions. Parts of
   * lower degree do not hold x and z by themselves, but 1, x, z are functions
   * of their own: rigid motions are exact in each, and the part q is not
   * exactly what LE-q with cells of its own shape would be.
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
    /// Nodal functions, in columns where the section is slender, or
    /// hierarchical ones, in which there are no columns.
    enum class Basis
    {
      nodal,
      hierarchical
    };

    /// The ratio of width and height from which grids are built in columns:
    /// below it the columns only cost (their functions couple with more). Of
    /// the width over the height, or the other way round.
    static constexpr double usual_column_aspect = 100.;

    /// @p degree p from 1. @p column_aspect is the ratio of the long to the
    /// short side of a rectangular grid from which on it is built in columns.
    /// A hierarchical basis takes no notice of it. Shares @p mesh.
    LagrangeElement(std::shared_ptr<const SectionMesh> mesh,
                    const unsigned int                 degree,
                    const double column_aspect = usual_column_aspect,
                    const Basis  basis         = Basis::nodal);

    /// Whether the basis is one in columns.
    bool
    has_columns() const
    {
      return in_columns;
    }

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
    /// whole columns, whose other nodal functions are of level 2; the degree of
    /// hierarchical functions.
    unsigned int
    level(const unsigned int tau) const override
    {
      return levels[tau];
    }

    /// Of a hierarchical basis the q of the LE-q that the function completes;
    /// 1, x, z belong to LE-1.
    unsigned int
    function_degree(const unsigned int tau) const override
    {
      return is_hierarchical() ? std::max(levels[tau], 1u) : degree();
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

    /// Of a hierarchical basis the nodes of LE-q, at their places in the map of
    /// degree p.
    std::vector<EdgePoint>
    coarse_edge_points(const std::string &boundary,
                       const unsigned int degree) const override;
    std::vector<EdgePoint>
    coarse_section_grid(const unsigned int degree) const override;

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

    /// A hierarchical function on a cell: sign l_i(xi) l_j(eta), with its
    /// number in the whole section.
    struct Product
    {
      unsigned int                number;
      std::array<unsigned int, 2> indices;
      double                      sign;
    };

    /// What a cell evaluates, in the order of its numbers: functions or, of a
    /// hierarchical basis, products.
    struct Cell
    {
      /// 0, 1, 2 and those of functions or products, ascending.
      std::vector<unsigned int>  numbers;
      std::vector<LocalFunction> functions;
      std::vector<Product>       products;
    };

    /// A grid of nodes: for each its place along the long side of the section
    /// and along the short one. Both counted from 0 in ascending coordinates.
    /// n_columns is 0 if there is none.
    struct Grid
    {
      std::vector<unsigned int> column, place;
      unsigned int              n_columns = 0, n_places = 0;
    };

    bool
    is_hierarchical() const
    {
      return basis == Basis::hierarchical;
    }

    /// The three of @p nodes that give way: two far apart and a third far off
    /// their line.
    std::array<unsigned int, 3>
    replaced_nodes(const std::vector<dealii::Point<2>> &nodes) const;

    /// The nodes as a grid of columns across the direction long_side, empty if
    /// they are none or the section is not slender. They are a grid if as many
    /// distinct x times as many distinct z are as many as there are nodes.
    Grid
    find_grid(const double column_aspect) const;

    /// Numbers for the basis of the general case: 0, 1, 2 and a node each.
    void
    number_nodal_functions();

    /// The numbers of the functions in columns: of each column the constant
    /// one and the slope, and of each node its own; 0 where there is none.
    struct ColumnNumbers
    {
      std::vector<unsigned int> constant, slope, of_node;
    };
    ColumnNumbers
    number_columns(const Grid &grid);

    /// Numbers for the basis in columns. 1, x, z stand for both functions of
    /// the first column and the constant one of the last.
    void
    number_column_functions(const Grid &grid);

    /// A hierarchical function of a section: its degree, the kind of what it is
    /// on (vertex, edge, cell) with the number of that, and its indices there.
    using ProductKey = std::array<unsigned int, 5>;
    /// Numbers for the hierarchical basis, degree after degree, without the
    /// three vertices that give way.
    std::map<ProductKey, unsigned int>
    number_products();
    void
    number_hierarchical_functions();

    /// Appends the functions of @p cell at @p unit to @p values; @p to_real
    /// turns gradients on the unit square into those in x and z.
    void
    append_functions(const Cell                 &cell,
                     const dealii::Point<2>     &unit,
                     const dealii::Tensor<2, 2> &to_real,
                     FunctionValues             &values) const;
    void
    append_products(const Cell                 &cell,
                    const dealii::Point<2>     &unit,
                    const dealii::Tensor<2, 2> &to_real,
                    FunctionValues             &values) const;

    /// edge_points() and section_grid() in the nodes of @p grid, which may be
    /// of a lower degree than the map.
    std::vector<EdgePoint>
    edge_points_of(const SectionGeometry &grid,
                   const std::string     &boundary) const;
    std::vector<EdgePoint>
    grid_points_of(const SectionGeometry &grid) const;

    /// Sorts the functions of each cell and lists their numbers.
    void
    collect_numbers();

    /// The isoparametric map in the expansion's own nodes.
    SectionGeometry geometry;
    Basis           basis;
    /// Of a hierarchical basis the nodes of the degrees 1 ... p - 1.
    std::vector<std::unique_ptr<const SectionGeometry>> coarse;
    /// Of each function its level(); of each cell its functions.
    std::vector<unsigned int> levels;
    std::vector<Cell>         cells;
    bool                      in_columns = false;
    /// Of a grid: 0 if the section is wide, 1 if it is high; and the length
    /// that makes the coordinate along a column dimensionless.
    unsigned int long_side     = 0;
    double       column_length = 1.;
  };
} // namespace lamella

#endif
