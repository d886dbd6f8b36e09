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
  /// The layer-wise Lagrange expansion LE-p of a cross-section (Eq. 3 of
  /// Nagaraj et al. 2020): deal.II's FE_Q<2>(p) on the section mesh, i.e. L4,
  /// L9 and L16 for p = 1, 2, 3, with Gauss-Lobatto nodes. Displacements are
  /// continuous, transverse strains may jump at ply interfaces. The geometry is
  /// isoparametric. There are three kinds of basis. In each, 1, (x - x_c)/h and
  /// (z - z_c)/h replace three functions; (x_c, z_c) is the centroid, h a
  /// length.
  /// - *nodal*: the nodal functions.
  /// - *in columns*, without rounding errors for rectangular grids much wider
  ///   than high: G_i(x) is the sum of the nodal functions of the column of
  ///   nodes at x_i. G_i and G_i (z - z_c) / h_z, with the height h_z, replace
  ///   two nodal functions of each column. For grids much higher than wide, x
  ///   and z are exchanged.
  /// - *hierarchical*, as in deal.II's FE_Q_Hierarchical, for beams with
  ///   degrees LE-1, LE-2, ... that differ between nodes of the axis: bilinear
  ///   functions of the vertices, and products
  ///     l_i(xi) l_j(eta),   max(i, j) = 2, 3, ..., p,
  ///     l_0 = 1 - t,  l_1 = t,
  ///     l_k = int_(-1)^(2t-1) P_(k-1) / |P_(k-1)| ds   for k > 1
  ///   with integrated Legendre polynomials (Szabo and Babuska 1991), for edges
  ///   if i or j < 2, otherwise for the interior of a cell. Functions of odd
  ///   degree on an edge have the sign of its direction, towards the vertex
  ///   with the larger number. The functions up to degree q span LE-q, so that
  ///   all degrees share the section matrices (doc/theory/theories.md).
  ///
  /// Curved cells are mapped with degree p. LE-q contains all rigid motions.
  class LagrangeElement : public CrossSectionElement
  {
  public:
    /// Kind of basis (see the class): nodal or in columns, or hierarchical.
    enum class Basis
    {
      nodal,
      hierarchical
    };

    /// Aspect ratio of a rectangular grid above which the basis is in columns.
    static constexpr double default_column_aspect = 100.;

    /// Constructs LE-p, p = @p degree, on @p mesh. A nodal basis is in columns
    /// on rectangular grids with an aspect ratio of at least @p column_aspect.
    LagrangeElement(const std::shared_ptr<const SectionMesh> &mesh,
                    const unsigned int                        degree,
                    const double column_aspect = default_column_aspect,
                    const Basis  basis         = Basis::nodal);

    /// Returns true if the nodal basis is in columns.
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

    /// Returns the rank of function @p tau, see the base class: 0 for 1, x, z;
    /// the degree of other hierarchical functions; 1 for other functions of a
    /// nodal basis, but 2 for nodal functions of a basis in columns.
    unsigned int
    level(const unsigned int tau) const override
    {
      return levels[tau];
    }

    /// Returns the degree of function @p tau if hierarchical, else degree().
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

    /// Evaluates the functions of @p cell; values below 1e-14 are set to zero.
    FunctionValues
    evaluate(const unsigned int      cell,
             const dealii::Point<2> &unit) const override;

    /// Returns the nodes on @p boundary. Weights integrate nodal functions.
    std::vector<EdgePoint>
    edge_points(const std::string &boundary) const override;

    /// Returns all nodes of the section.
    std::vector<EdgePoint>
    section_points() const override
    {
      return section_grid();
    }

    /// Returns all nodes, weighted by integrals of nodal functions [length^2].
    std::vector<EdgePoint>
    section_grid() const override;

    /// Returns edge_points() of LE-q, q = @p degree, if the basis is
    /// hierarchical, otherwise of LE-p.
    std::vector<EdgePoint>
    coarse_edge_points(const std::string &boundary,
                       const unsigned int degree) const override;
    /// Returns section_grid() of LE-q, q = @p degree, if the basis is
    /// hierarchical, otherwise of LE-p.
    std::vector<EdgePoint>
    coarse_section_grid(const unsigned int degree) const override;

  private:
    /// A basis function on a cell. N_i are the nodal functions of the nodes
    /// with local numbers `nodes`, z is the coordinate along a column, z_c its
    /// value at the centroid, and h_z the length of a column:
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

    /// Product sign l_i(xi) l_j(eta) of integrated Legendre polynomials l.
    struct Product
    {
      unsigned int                number;
      std::array<unsigned int, 2> indices;
      double                      sign;
    };

    /// The basis functions of a cell: `functions`, or hierarchical `products`.
    struct Cell
    {
      /// Numbers of the nonzero basis functions on the cell, ascending.
      std::vector<unsigned int>  numbers;
      std::vector<LocalFunction> functions;
      std::vector<Product>       products;
    };

    /// A rectangular grid of nodes. Each node has an index from 0 along the
    /// long side (`column`) and along the short side (`place`). n_columns is 0
    /// if the nodes are not a grid.
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

    /// Returns three nodes, not on a line, whose functions 1, x, z replace.
    std::array<unsigned int, 3>
    replaced_nodes(const std::vector<dealii::Point<2>> &nodes) const;

    /// Returns the grid with columns across its long side; it is empty if the
    /// section is not slender or not a rectangular grid.
    Grid
    find_grid(const double column_aspect) const;

    /// Numbers the functions of the nodal basis.
    void
    number_nodal_functions();

    /// Numbers of the functions G_i and G_i (z - z_c) / h_z of each column and
    /// of the nodal functions N_i; 0 if 1, x or z replaces the function.
    struct ColumnNumbers
    {
      std::vector<unsigned int> constant, slope, of_node;
    };
    ColumnNumbers
    number_columns(const Grid &grid);

    /// Numbers the functions of the basis in columns. 1, x, z replace both
    /// functions of the first column and G_i of the last.
    void
    number_column_functions(const Grid &grid);

    /// Sort key of a hierarchical function: degree, kind of support (vertex,
    /// edge or cell), number of the vertex, edge or cell, and indices i, j.
    using ProductKey = std::array<unsigned int, 5>;
    /// Numbers the hierarchical functions by degree, without the three vertex
    /// functions that 1, x, z replace.
    std::map<ProductKey, unsigned int>
    number_products();
    void
    number_hierarchical_functions();

    /// Appends the values of nodal or column functions of @p cell at @p unit to
    /// @p values. @p to_real transforms gradients from (xi, eta) to (x, z).
    void
    append_functions(const Cell                 &cell,
                     const dealii::Point<2>     &unit,
                     const dealii::Tensor<2, 2> &to_real,
                     FunctionValues             &values) const;
    /// Appends the values of hierarchical functions, with the same arguments.
    void
    append_products(const Cell                 &cell,
                    const dealii::Point<2>     &unit,
                    const dealii::Tensor<2, 2> &to_real,
                    FunctionValues             &values) const;

    /// Returns edge_points() for the nodes of @p grid.
    std::vector<EdgePoint>
    edge_points_of(const SectionGeometry &grid,
                   const std::string     &boundary) const;
    /// Returns section_grid() for the nodes of @p grid.
    std::vector<EdgePoint>
    grid_points_of(const SectionGeometry &grid) const;

    /// Sorts the functions of each cell by their index in the section and
    /// stores these indices in Cell::numbers.
    void
    collect_numbers();

    Basis basis;
    /// Maps with the nodes of degrees 1 ... p - 1 of a hierarchical basis.
    std::vector<std::unique_ptr<const SectionGeometry>> coarse;
    /// Result of level() for each function.
    std::vector<unsigned int> levels;
    std::vector<Cell>         cells;
    bool                      in_columns = false;
    /// Direction of the long side of the grid (0: x, 1: z), and length h_z.
    unsigned int long_side     = 0;
    double       column_length = 1.;
  };
} // namespace lamella

#endif
