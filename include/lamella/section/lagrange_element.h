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
   * mesh, L4, L9 and L16 for p = 1, 2, 3 (nodes are Gauss-Lobatto points). The
   * geometry is isoparametric, so x and z are in the span of the nodal
   * functions, and each basis below spans exactly LE. It is the layer-wise (LW)
   * expansion if each ply has its cells: u is continuous, transverse strains
   * may jump at interfaces.
   *
   * The nodal basis is as follows: 1, (x - x_c)/h, (z - z_c)/h replace the
   * nodal functions of three nodes not on a line; the other nodal functions are
   * warping.
   *
   * A rectangular grid much wider than high loses digits across the width as
   * along a slender axis, so its basis is built in columns. G_i(x) is the sum
   * of the nodal functions of the column at x_i. G_i and G_i (z - z_c) / h_z
   * replace two nodes of each column, and 1, x, z three of these. (x and z are
   * exchanged if the grid is much higher than wide.)
   *
   * If nodes of one beam have LE-1, LE-2, ... the basis is *hierarchical* by
   * degree, as deal.II's FE_Q_Hierarchical: the bilinear functions of the
   * vertices, and products
   *   l_i(xi) l_j(eta),   max(i, j) = 2, 3, ..., p,
   *   l_0 = 1 - t,  l_1 = t,
   *   l_k = int_(-1)^(2t-1) P_(k-1) / |P_(k-1)| ds   for k > 1
   * (integrated Legendre polynomials, Szabo and Babuska 1991, zero at both
   * ends), on edges if i or j is below 2, else inside of a cell. The sign of
   * odd ones on an edge follows its direction, from the vertex of the smaller
   * number. 1, x, z replace three vertices. Functions are numbered by degree:
   * those up to degree q span LE-q, so that LE-1, LE-2, ... share one set of
   * S_pq. Factors are larger and condition numbers double
   * (doc/theory/theories.md).
   *
   * The map on curved cells is of degree p for all functions. Rigid motions are
   * exact in each part, but the part q is not exactly LE-q on cells of its own
   * shape.
   */
  class LagrangeElement : public CrossSectionElement
  {
  public:
    /// Kind of basis: nodal (in columns if slender), or hierarchical.
    enum class Basis
    {
      nodal,
      hierarchical
    };

    /// Ratio of the sides of a grid from which columns are used.
    static constexpr double default_column_aspect = 100.;

    /// Constructs LE of @p degree; shares @p mesh. @p column_aspect is the
    /// ratio of sides of a rectangular grid from which a nodal basis has
    /// columns.
    LagrangeElement(std::shared_ptr<const SectionMesh> mesh,
                    const unsigned int                 degree,
                    const double column_aspect = default_column_aspect,
                    const Basis  basis         = Basis::nodal);

    /// Returns true for a basis in columns.
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

    /// Returns 0 for 1, x, z; else 1 (with columns 2 for functions of single
    /// nodes); the degree of hierarchical functions.
    unsigned int
    level(const unsigned int tau) const override
    {
      return levels[tau];
    }

    /// Returns for a hierarchical basis the q of the function, else degree().
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

    /// Returns values, with those below 1e-14 set to 0.
    FunctionValues
    evaluate(const unsigned int      cell,
             const dealii::Point<2> &unit) const override;

    SectionGeometry::Place
    map(const unsigned int cell, const dealii::Point<2> &unit) const override
    {
      return geometry.map(cell, unit);
    }

    /// Returns the nodes on the boundary, weighted by their functions.
    std::vector<EdgePoint>
    edge_points(const std::string &boundary) const override;

    /// Returns the nodes.
    std::vector<EdgePoint>
    section_points() const override
    {
      return section_grid();
    }

    /// Returns the nodes, weighted by integrals of nodal functions [length^2].
    std::vector<EdgePoint>
    section_grid() const override;

    /// Return for a hierarchical basis the nodes of LE-q.
    std::vector<EdgePoint>
    coarse_edge_points(const std::string &boundary,
                       const unsigned int degree) const override;
    std::vector<EdgePoint>
    coarse_section_grid(const unsigned int degree) const override;

  private:
    /// A nonzero function on a cell, of nodal functions N_i of @p nodes (local
    /// numbers) and the coordinate z along a column.
    ///   nodal         N_i
    ///   column        G = sum N_i over the column's nodes on the cell
    ///   column_slope  G (z - z_c) / h_z
    struct LocalFunction
    {
      enum class Kind
      {
        nodal,
        column,
        column_slope
      };
      /// Number of the function in the whole section.
      unsigned int              number;
      Kind                      kind;
      std::vector<unsigned int> nodes;
    };

    /// A hierarchical function on a cell, sign l_i(xi) l_j(eta).
    struct Product
    {
      unsigned int                number;
      std::array<unsigned int, 2> indices;
      double                      sign;
    };

    /// Functions or, for a hierarchical basis, products of a cell.
    struct Cell
    {
      /// Numbers 0, 1, 2 and those of functions or products, ascending.
      std::vector<unsigned int>  numbers;
      std::vector<LocalFunction> functions;
      std::vector<Product>       products;
    };

    /// A grid of nodes: their positions along the long side (column) and the
    /// short side, from 0, ascending. n_columns is 0 if there is no grid.
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

    /// Returns three of @p nodes to replace, far from a line.
    std::array<unsigned int, 3>
    replaced_nodes(const std::vector<dealii::Point<2>> &nodes) const;

    /// Returns the grid of columns across long_side, empty if the section is
    /// not slender or no rectangular grid.
    Grid
    find_grid(const double column_aspect) const;

    /// Sets numbers of the general nodal basis: 0, 1, 2 and one per other node.
    void
    number_nodal_functions();

    /// Function numbers: constants and slopes of columns, and nodes; 0: none.
    struct ColumnNumbers
    {
      std::vector<unsigned int> constant, slope, of_node;
    };
    ColumnNumbers
    number_columns(const Grid &grid);

    /// Sets numbers of the basis in columns. 1, x, z replace both functions of
    /// the first column and the constant of the last.
    void
    number_column_functions(const Grid &grid);

    /// Key of a hierarchical function: degree, kind of support (vertex, edge,
    /// cell), number of support, two indices.
    using ProductKey = std::array<unsigned int, 5>;
    /// Returns hierarchical numbers by degree, without replaced vertices.
    std::map<ProductKey, unsigned int>
    number_products();
    void
    number_hierarchical_functions();

    /// Append the functions of @p cell at @p unit to @p values; @p to_real
    /// transforms gradients on the unit square into those in x and z.
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

    /// Return edge_points() and section_grid() at the nodes of @p grid.
    std::vector<EdgePoint>
    edge_points_of(const SectionGeometry &grid,
                   const std::string     &boundary) const;
    std::vector<EdgePoint>
    grid_points_of(const SectionGeometry &grid) const;

    /// Sorts the functions of each cell and lists their numbers.
    void
    collect_numbers();

    /// Isoparametric map in the expansion's own nodes.
    SectionGeometry geometry;
    Basis           basis;
    /// Nodes of the degrees 1 ... p - 1 of a hierarchical basis.
    std::vector<std::unique_ptr<const SectionGeometry>> coarse;
    /// Result of level() for each function; functions of each cell.
    std::vector<unsigned int> levels;
    std::vector<Cell>         cells;
    bool                      in_columns = false;
    /// Direction of a grid, 0 if wide, 1 if high, and the length h_z.
    unsigned int long_side     = 0;
    double       column_length = 1.;
  };
} // namespace lamella

#endif
