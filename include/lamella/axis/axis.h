// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `axis`: the mesh of a beam's axis, the axis elements B2, B3, B4,
// their shape functions N_i(y) in u = F_tau N_i u_(tau i) (Eq. 7), the
// integration points of shear strains, and the matrices A_pq. The functions
// F_tau(x, z) are in the room `section`.

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
  /// The mesh along the axis in a scene, checked by AxisParameters. Solids are
  /// extruded with the same pieces; the rest applies to beams only.
  struct AxisMesh
  {
    /// Length of the axis, positive; y is in [0, length].
    double length = 0.;
    /// Degree of N_i: 1, 2, 3 for B2, B3, B4. B4 is exact for a beam in bending
    /// by end forces.
    unsigned int degree = 3;
    /// Equal elements in each piece between 0, the breaks and the length.
    std::vector<unsigned int> elements;
    /// Distances of the ends of pieces from the start, ascending, strictly
    /// between 0 and the length. Short pieces grade a mesh.
    std::vector<double> breaks;
    /// Refinement factor of automatic grading (grade_axes()), which sets
    /// elements and breaks by the contacts of the body; 0: they are given.
    double refinement_factor = 0.;
    /// True if nodes are equidistant, as in the CUF literature's B4, instead of
    /// the Gauss-Lobatto points of FE_Q. No effect on B2 and B3.
    bool equidistant_nodes = false;
    /// True if transverse shear strains are assumed one degree lower (MITC).
    bool assumed_shear = false;
  };

  /// Returns the lengths of the elements from the start of the complete
  /// @p description.
  std::vector<double>
  element_lengths(const AxisMesh &description);

  /// Nonzero shape functions of an axis element at a point. Nodal values u_i
  /// have
  ///   the value sum N_i u_i,   the derivative sum N_i' u_i along y,
  ///   and in transverse shear strains the value sum N^_i u_i.
  struct AxisPoint
  {
    /// Number of the element, from 0 along the axis.
    unsigned int cell = 0;
    /// Distance from the start of the axis [length].
    double y = 0.;
    /// N_i and dN_i / dy [1/length], degree + 1 each, in the order of
    /// Axis::nodes_of_cell(): the two ends first.
    std::vector<double> N, dN;
    /// N in transverse shear strains: N, or its projection N^.
    std::vector<double> N_shear;
  };

  /**
   * The axis of a beam: FE_Q<1>(1..3) on a mesh of [0, length], nodes numbered
   * along y, and the four matrices of Eq. 12,
   *   A_NN = int N_i N_j,  A_NdN = int N_i N_j',  A_dNdN = int N_i' N_j'
   * and A_dNN, the transpose of A_NdN, with ' = d/dy and integrals over the
   * length. Units: length, none, 1 / length. Rows and columns are nodes.
   *
   * B2 and B3 lock in shear: in gamma_yz = w' + a, the slope w' has one degree
   * less than the rotation a that cancels it in a slender beam. Assumed shear
   * strains interpolate the rotation at the degree() Gauss points of an element
   * (Dvorkin and Bathe's MITC for a beam). This is its projection N^ on
   * polynomials of one degree less. Since N' has that degree, int N^ N' = int N
   * N' and int N^ N = int N^ N^: only A_shear = int N^_i N^_j is needed in
   * addition.
   *
   * Every process has the whole axis. It owns contiguous elements (for loops)
   * and, independently, contiguous nodes (for rows of matrices). Lengths are in
   * the scene's unit, y is the body's own axis. Immutable.
   */
  class Axis
  {
  public:
    /// Meshes, numbers the nodes and integrates the matrices. Collective.
    explicit Axis(const AxisMesh &description);

    /// Returns the degree of N_i on an element.
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

    /// Returns whether N_shear differs from N.
    bool
    has_assumed_shear() const
    {
      return description.assumed_shear;
    }

    /// Returns n_cells() * degree() + 1, the number on all processes.
    unsigned int
    n_nodes() const
    {
      return node_positions.size();
    }

    /// Returns the number of elements, numbered from 0 along the axis.
    unsigned int
    n_cells() const
    {
      return cell_nodes.size();
    }

    /// Returns the elements that this process integrates over, first and one
    /// past the last; possibly none.
    std::pair<unsigned int, unsigned int>
    own_cells() const
    {
      return owned_cells;
    }

    /// Returns the nodes of this process's rows, first and one past the last.
    std::pair<unsigned int, unsigned int>
    own_nodes() const;

    /// Returns y of each node, ascending from 0 to length(), by node number.
    const std::vector<double> &
    nodes() const
    {
      return node_positions;
    }

    /// Returns the nodes of @p cell as AxisPoint::N: begin, end, interior.
    const std::vector<unsigned int> &
    nodes_of_cell(const unsigned int cell) const
    {
      return cell_nodes[cell];
    }

    /// Returns y at the begin (and at the end) of @p cell.
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

    /// Returns the shape functions at y = cell_begin + @p eta (cell_end -
    /// cell_begin) of @p cell. Values of N below 1e-14 are exactly zero.
    AxisPoint
    evaluate(const unsigned int cell, const double eta) const;

    /// Returns the cells that contain @p y within @p tolerance [length], with
    /// eta in [0, 1] (exactly 0 or 1 at an end within the tolerance): two at a
    /// node between elements, none outside of the axis.
    std::vector<std::pair<unsigned int, double>>
    locate(const double y, const double tolerance) const;

    /// Returns the first cell with @p node and the node's eta in it.
    std::pair<unsigned int, double>
    cell_of_node(const unsigned int node) const;

    /// Returns int N_i dy of each node. Times an edge length in the section
    /// they are the tributary areas of contact nodes.
    std::vector<double>
    node_weights() const;

    /// Returns the integration points of all cells, degree + 1 Gauss points
    /// each, exact for products of two N_i.
    const std::vector<AxisPoint> &
    integration_points() const
    {
      return points;
    }

    /// Returns the integration weights [length], with the sum length().
    const std::vector<double> &
    integration_weights() const
    {
      return weights;
    }

    /// Returns a matrix of Eq. 12. @p p, @p q in {0, 1} are the orders of the
    /// derivatives of the row's and the column's function: A(0, 1) = A_NdN. All
    /// five matrices share the sparsity pattern and are whole on every process.
    const Matrix &
    A(const unsigned int p, const unsigned int q) const
    {
      return matrices[2 * p + q];
    }

    /// Returns int N^_i N^_j, or A(0, 0) without assumed shear strains. It
    /// replaces A(0, 0) for Section::S_shear.
    const Matrix &
    A_shear() const
    {
      return matrices[4];
    }

  private:
    /// Makes the elements of element_lengths(), in equal numbers per process.
    void
    make_mesh();
    /// Renumbers deal.II's nodes along y.
    void
    number_nodes();
    /// Integrates the matrices, and stores the integration points.
    void
    make_matrices();

    /// Returns N^_i at @p eta in [0, 1]: sum_q L_q(eta) N_i(eta_q), with the
    /// Gauss points eta_q and their Lagrange polynomials L_q.
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

    /// A(p, q) at 2 p + q, then A_shear; they refer to the pattern.
    dealii::SparsityPattern sparsity;
    std::array<Matrix, 5>   matrices;
  };
} // namespace lamella

#endif
