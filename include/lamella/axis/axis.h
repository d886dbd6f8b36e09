// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `axis`: the beam's other factor. It owns the mesh of the axis, which
// is deal.II's, the axis elements B2, B3, B4, their shape functions and the
// points that shear is taken at, and the matrices A_pq that go with the S_pq.
// It never knows the section.

#ifndef lamella_axis_axis_h
#define lamella_axis_axis_h

#include <lamella/base/linear_algebra.h>

#include <deal.II/distributed/shared_tria.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_q.h>

#include <string>
#include <vector>

namespace lamella
{
  /// What a scene says of the mesh along the axis.
  struct AxisMesh
  {
    double length = 0.;
    /// Degree of N_i: 1, 2, 3 for B2, B3, B4.
    unsigned int degree = 3;
    /// Equal elements in each piece between 0, the breaks and the length.
    std::vector<unsigned int> elements;
    std::vector<double>       breaks;
    /// Nodes at equal distances, as in the CUF literature's B4, instead of at
    /// the Gauss-Lobatto points of FE_Q: the same space, other contact pairs.
    bool equidistant_nodes = false;
    /// Whether transverse shear strains are assumed one degree lower (MITC).
    /// B2 and B3 lock in shear without it; B4 does not need it.
    bool assumed_shear = false;
  };

  /// The lengths of the elements along the axis.
  std::vector<double>
  element_lengths(const AxisMesh &description);

  /// The shape functions that do not vanish on an axis element, at a point.
  struct AxisPoint
  {
    unsigned int        cell = 0;
    double              y    = 0.;
    std::vector<double> N, dN;
    /// What stands for N in the transverse shear strains: N itself, or its
    /// projection on the polynomials of one degree less.
    std::vector<double> N_shear;
  };

  /**
   * The axis of a beam: FE_Q<1>(1..3) on a mesh of [0, length], nodes numbered
   * along y, and the four matrices of Eq. 12 over the axis,
   *   A_NN = int N_i N_j,  A_NdN = int N_i N_j',  A_dNdN = int N_i' N_j'.
   *
   * In a transverse shear strain N w' + N' ... the slope of the deflection is
   * of one degree less than the rotation that it must cancel in a slender beam:
   * B2 and B3 then lock. With assumed shear strains the rotation's part is
   * interpolated in the degree() Gauss points of an element (Dvorkin and
   * Bathe's mixed interpolation of tensorial components, MITC, for a beam),
   * which is its projection N^ on the polynomials of one degree less. Since N'
   * is one of those, int N^ N' = int N N' and int N^ N = int N^ N^: one more
   * small matrix, A_shear = int N^_i N^_j, is all that it takes.
   *
   * Every process has the whole axis. Of its elements each owns a part in a
   * row, for loops, and so of its nodes, for the rows of matrices; nodes are
   * shared out on their own, so that few elements do for many processes.
   */
  class Axis
  {
  public:
    explicit Axis(const AxisMesh &description);

    unsigned int
    degree() const
    {
      return fe.degree;
    }

    double
    length() const
    {
      return description.length;
    }

    unsigned int
    n_nodes() const
    {
      return node_positions.size();
    }

    unsigned int
    n_cells() const
    {
      return cell_nodes.size();
    }

    /// The elements that this process integrates over, first and one past the
    /// last; perhaps none.
    std::pair<unsigned int, unsigned int>
    own_cells() const
    {
      return owned_cells;
    }

    /// The nodes whose rows this process keeps, likewise.
    std::pair<unsigned int, unsigned int>
    own_nodes() const;

    /// y of each node, ascending.
    const std::vector<double> &
    nodes() const
    {
      return node_positions;
    }

    /// Nodes of @p cell in the order of AxisPoint::N.
    const std::vector<unsigned int> &
    nodes_of_cell(const unsigned int cell) const
    {
      return cell_nodes[cell];
    }

    double
    cell_begin(const unsigned int cell) const
    {
      return cell_bounds[cell].first;
    }

    double
    cell_end(const unsigned int cell) const
    {
      return cell_bounds[cell].second;
    }

    /// Shape functions and their derivatives with respect to y at @p eta of
    /// [0, 1] of @p cell.
    AxisPoint
    evaluate(const unsigned int cell, const double eta) const;

    /// The cells that hold @p y within @p tolerance, with the place in [0, 1]:
    /// two at a node between elements, none outside of the axis.
    std::vector<std::pair<unsigned int, double>>
    locate(const double y, const double tolerance) const;

    /// A cell that has @p node, and the node's place in it.
    std::pair<unsigned int, double>
    place_of_node(const unsigned int node) const;

    /// int N_i dy of each node.
    std::vector<double>
    node_weights() const;

    /// The integration points, degree + 1 Gauss points a cell, with weights.
    const std::vector<AxisPoint> &
    integration_points() const
    {
      return points;
    }

    const std::vector<double> &
    integration_weights() const
    {
      return weights;
    }

    /// p, q in {0, 1}: whether the row's and the column's function is
    /// differentiated. A(0, 1) = A_NdN.
    const Matrix &
    A(const unsigned int p, const unsigned int q) const
    {
      return matrices[2 * p + q];
    }

    /// int N^_i N^_j: A(0, 0) unless shear strains are assumed.
    const Matrix &
    A_shear() const
    {
      return matrices[4];
    }

  private:
    void
    make_mesh();
    void
    number_nodes();
    void
    make_matrices();

    /// Values of N^_i at @p eta of [0, 1].
    std::vector<double>
    projected_shape_functions(const double eta) const;

    AxisMesh                                   description;
    dealii::parallel::shared::Triangulation<1> mesh;
    dealii::FE_Q<1>                            fe;
    dealii::DoFHandler<1>                      dof_handler;

    std::vector<double>                    node_positions;
    std::vector<std::vector<unsigned int>> cell_nodes;
    std::vector<std::pair<double, double>> cell_bounds;
    std::pair<unsigned int, unsigned int>  owned_cells;

    std::vector<AxisPoint> points;
    std::vector<double>    weights;

    dealii::SparsityPattern sparsity;
    std::array<Matrix, 5>   matrices;
  };
} // namespace lamella

#endif
