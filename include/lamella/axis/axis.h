// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `axis`: the beam's other factor. It owns the mesh of the axis, which
// is deal.II's, the axis elements B2, B3, B4, their shape functions and the
// points that shear is taken at, and the matrices A_pq that go with the S_pq.
// It never knows the section.
//
// In the paper the axis is the index i of Eq. 7, u = F_tau N_i u_(tau i): all
// that depends on N_i(y) is here, all that depends on F_tau(x, z) in `section`.

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
  /**
   * What a scene says of the mesh along the axis: plain data, which
   * AxisParameters checks. Solids are extruded along the same pieces; degree,
   * nodes and shear strains are a beam's alone.
   */
  struct AxisMesh
  {
    /// Of the axis, positive. y runs from 0 to here.
    double length = 0.;
    /// Degree of N_i: 1, 2, 3 for B2, B3, B4. The cubic B4 is exact for a beam
    /// that bends under forces at its ends.
    unsigned int degree = 3;
    /// Equal elements in each piece between 0, the breaks and the length: one
    /// number more than breaks, each at least 1.
    std::vector<unsigned int> elements;
    /// Where one piece ends and the next begins: distances from the start,
    /// ascending, strictly between 0 and the length. Short pieces grade a mesh
    /// towards a clamp or a load.
    std::vector<double> breaks;
    /// Above 0: elements and breaks are not given but follow from what touches
    /// the body (grade_axes()), shorter by this factor than its rules say.
    double fineness = 0.;
    /// Nodes at equal distances, as in the CUF literature's B4, instead of at
    /// the Gauss-Lobatto points of FE_Q: the same space, other contact pairs.
    /// For B2 and B3 both are the same.
    bool equidistant_nodes = false;
    /// Whether transverse shear strains are assumed one degree lower (MITC).
    /// B2 and B3 lock in shear without it; B4 does not need it.
    bool assumed_shear = false;
  };

  /// The lengths of the elements along the axis, from its start on; their sum
  /// is the length. @p description has to be complete.
  std::vector<double>
  element_lengths(const AxisMesh &description);

  /**
   * The shape functions that do not vanish on an axis element, at a point: all
   * that a beam asks of its axis there. With them a field with the nodal values
   * u_i has at this point
   *   the value sum N_i u_i,   the derivative sum N_i' u_i along y,
   *   and in transverse shear strains the value sum N^_i u_i.
   */
  struct AxisPoint
  {
    /// The element, from 0 on along the axis.
    unsigned int cell = 0;
    /// From the start of the axis (a length).
    double y = 0.;
    /// N_i and dN_i / dy (one over a length), degree + 1 each, in the order of
    /// Axis::nodes_of_cell(): the two ends first, as in deal.II's FE_Q.
    std::vector<double> N, dN;
    /// What stands for N in the transverse shear strains: N itself, or its
    /// projection N^ on the polynomials of one degree less.
    std::vector<double> N_shear;
  };

  /**
   * The axis of a beam: FE_Q<1>(1..3) on a mesh of [0, length], nodes numbered
   * along y, and the four matrices of Eq. 12 over the axis,
   *   A_NN = int N_i N_j,  A_NdN = int N_i N_j',  A_dNdN = int N_i' N_j'
   * and A_dNN, the transpose of A_NdN. The prime is d/dy, the integrals go from
   * 0 to the length. Units: length, none, 1 / length. They have as many rows as
   * nodes and are banded, with at most 2 degree() + 1 entries a row.
   *
   * In a transverse shear strain, gamma_yz = w' + a say, the slope w' of the
   * deflection is of one degree less than the rotation a that it must cancel in
   * a slender beam: B2 and B3 then lock. With assumed shear strains the
   * rotation's part is interpolated in the degree() Gauss points of an element
   * (Dvorkin and Bathe's mixed interpolation of tensorial components, MITC, for
   * a beam), which is its projection N^ on the polynomials of one degree less
   * (what is left is a multiple of the Legendre polynomial that vanishes in
   * those points, orthogonal to all of lower degree). Since N' is one of those,
   * int N^ N' = int N N' and int N^ N = int N^ N^: one more small matrix,
   * A_shear = int N^_i N^_j, is all that it takes.
   *
   * Every process has the whole axis. Of its elements each owns a part in a
   * row, for loops, and so of its nodes, for the rows of matrices; nodes are
   * shared out on their own, so that few elements do for many processes.
   *
   * Owns its mesh and DoF handler, on the run's communicator, refers to nothing
   * else, and never changes once it is made. Lengths are those of the scene, y
   * is the body's own axis.
   */
  class Axis
  {
  public:
    /// Meshes, numbers the nodes and integrates the matrices; @p description
    /// has to be complete. Collective.
    explicit Axis(const AxisMesh &description);

    /// Of N_i on an element.
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

    /// Whether N_shear differs from N.
    bool
    has_assumed_shear() const
    {
      return description.assumed_shear;
    }

    /// n_cells() * degree() + 1, on all processes together.
    unsigned int
    n_nodes() const
    {
      return node_positions.size();
    }

    /// The elements, numbered from 0 on along the axis.
    unsigned int
    n_cells() const
    {
      return cell_nodes.size();
    }

    /// The elements that this process integrates over, first and one past the
    /// last; perhaps none. Equal numbers of them, whatever their lengths.
    std::pair<unsigned int, unsigned int>
    own_cells() const
    {
      return owned_cells;
    }

    /// The nodes whose rows this process keeps, likewise; they need not be
    /// nodes of own_cells().
    std::pair<unsigned int, unsigned int>
    own_nodes() const;

    /// y of each node, ascending, from 0 to length(). A node's number is its
    /// place here.
    const std::vector<double> &
    nodes() const
    {
      return node_positions;
    }

    /// Nodes of @p cell in the order of AxisPoint::N: its begin, its end, and
    /// then those inside. Sort them for the order along y.
    const std::vector<unsigned int> &
    nodes_of_cell(const unsigned int cell) const
    {
      return cell_nodes[cell];
    }

    /// y at the two ends of @p cell.
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
    /// [0, 1] of @p cell, y = cell_begin + eta (cell_end - cell_begin). Values
    /// of N below 1e-14 are zero exactly, so that rows at nodes stay short.
    AxisPoint
    evaluate(const unsigned int cell, const double eta) const;

    /// The cells that hold @p y within @p tolerance (a length, far below that
    /// of an element), with the place in [0, 1]: two at a node between
    /// elements, none outside of the axis. Within the tolerance of an element's
    /// end the place is 0 or 1 exactly. Looks at each element.
    std::vector<std::pair<unsigned int, double>>
    locate(const double y, const double tolerance) const;

    /// A cell that has @p node, the first along the axis, and the node's place
    /// eta in it. Looks at each element.
    std::pair<unsigned int, double>
    place_of_node(const unsigned int node) const;

    /// int N_i dy of each node: the length of axis that belongs to it. They are
    /// positive and sum to length(). Times an edge's length in the section they
    /// are the tributary areas of contact nodes.
    std::vector<double>
    node_weights() const;

    /// The integration points, degree + 1 Gauss points a cell, cell after cell,
    /// all of them on every process. They integrate products of two N_i
    /// exactly.
    const std::vector<AxisPoint> &
    integration_points() const
    {
      return points;
    }

    /// Their weights, lengths that sum to length().
    const std::vector<double> &
    integration_weights() const
    {
      return weights;
    }

    /// p, q in {0, 1}: whether the row's and the column's function is
    /// differentiated. A(0, 1) = A_NdN. All five matrices share one sparsity
    /// pattern, that of nodes with an element in common, and every process has
    /// the whole of them.
    const Matrix &
    A(const unsigned int p, const unsigned int q) const
    {
      return matrices[2 * p + q];
    }

    /// int N^_i N^_j: A(0, 0) unless shear strains are assumed. It takes the
    /// place of A(0, 0) for the part of S_00 that has a transverse shear strain
    /// on either side (Section::S_shear).
    const Matrix &
    A_shear() const
    {
      return matrices[4];
    }

  private:
    /// The elements of element_lengths(), shared out to the processes in equal
    /// numbers.
    void
    make_mesh();
    /// Renumbers deal.II's nodes along y.
    void
    number_nodes();
    /// The integration points as well.
    void
    make_matrices();

    /// Values of N^_i at @p eta of [0, 1]: with eta_q the degree() Gauss points
    /// and L_q the Lagrange polynomials in them, sum_q L_q(eta) N_i(eta_q).
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
