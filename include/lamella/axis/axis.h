// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `axis`: the mesh of a beam's axis, the elements B2, B3, B4 with
// their shape functions N_i(y) in u = F_tau N_i u_(tau i) (Eq. 7), and the
// matrices A_pq, integrals of N_i^(p) N_j^(q). The section functions
// F_tau(x, z) are in the room `section`. It is independent of the section.

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
  /// Description of the mesh along the axis of a body. Extruded solids use
  /// `length`, `elements` and `breaks`; the other members apply to beams only.
  struct AxisMesh
  {
    /// Length of the axis, positive; the coordinate y is in [0, length].
    double length = 0.;
    /// Degree of the shape functions N_i: 1, 2, 3 for B2, B3, B4. B4 is exact
    /// for bending by end forces.
    unsigned int degree = 3;
    /// Number of equal elements in each interval between the breaks.
    std::vector<unsigned int> elements;
    /// Coordinates y, ascending strictly between 0 and the length, that divide
    /// the axis into intervals with different element lengths.
    std::vector<double> breaks;
    /// Refinement factor of automatic grading (grade_axes()), which computes
    /// `elements` and `breaks` from the contacts of a body; 0: none.
    double refinement_factor = 0.;
    /// True if the nodes of B4 are equidistant, as in the CUF literature,
    /// instead of Gauss-Lobatto points. No effect on B2 and B3.
    bool equidistant_nodes = false;
    /// True if transverse shear strains are assumed strains of one degree less
    /// (MITC), which avoids shear locking.
    bool assumed_shear = false;
  };

  /// Returns the lengths of all elements, from the start of the axis.
  std::vector<double>
  element_lengths(const AxisMesh &description);

  /// Shape functions of an axis element at a point. With nodal values u_i,
  ///   u = sum N_i u_i,   du/dy = sum N_i' u_i,
  /// and u = sum N^_i u_i in transverse shear strains (N^: see Axis).
  struct AxisPoint
  {
    /// Number of the element, from 0 along the axis.
    unsigned int cell = 0;
    /// Distance from the start of the axis [length].
    double y = 0.;
    /// Values N_i and derivatives dN_i / dy [1/length] of the degree + 1 shape
    /// functions in the order of Axis::nodes_of_cell(): the two ends first.
    std::vector<double> N, dN;
    /// Shape functions in transverse shear strains: N^ if assumed, else N.
    std::vector<double> N_shear;
  };

  /// The finite element discretization of a beam's axis: shape functions N_i of
  /// FE_Q<1> of degree 1 to 3 on [0, length] and the axis matrices,
  ///   A_NN = int N_i N_j,  A_NdN = int N_i N_j',  A_dNdN = int N_i' N_j'
  /// and A_dNN, the transpose of A_NdN, with ' = d/dy. Rows and columns are
  /// nodes, numbered along y.
  ///
  /// B2 and B3 lock in shear: in gamma_yz = w' + a with deflection w and
  /// rotation a, w' has one degree less than a. Assumed shear strains (MITC,
  /// Dvorkin and Bathe) interpolate N_i at the degree() Gauss points of an
  /// element, which projects N_i onto polynomials N^_i of one degree less.
  /// Since int N^_i N_j' = int N_i N_j' and int N^_i N_j = int N^_i N^_j, only
  /// the matrix A_shear = int N^_i N^_j is needed in addition.
  ///
  /// Every process stores the whole axis. Each process owns a contiguous range
  /// of elements for loops and, independently, of nodes for matrix rows. y is
  /// the body's own axis. Immutable.
  class Axis
  {
  public:
    /// Creates the mesh, numbers the nodes and integrates the matrices. Must be
    /// called by all processes.
    explicit Axis(const AxisMesh &description);

    /// Returns the degree of the shape functions N_i.
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

    /// Returns whether transverse shear strains are assumed (MITC).
    bool
    has_assumed_shear() const
    {
      return description.assumed_shear;
    }

    /// Returns the number of nodes on all processes, n_cells() * degree() + 1.
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

    /// Returns the range of elements that this process integrates over, as the
    /// first and one past the last; may be empty.
    std::pair<unsigned int, unsigned int>
    own_cells() const
    {
      return owned_cells;
    }

    /// Returns the range of nodes whose matrix rows this process owns, as the
    /// first and one past the last.
    std::pair<unsigned int, unsigned int>
    own_nodes() const;

    /// Returns the coordinate y of each node, ascending from 0 to length().
    const std::vector<double> &
    nodes() const
    {
      return node_positions;
    }

    /// Returns the nodes of the element @p cell in the order of AxisPoint::N:
    /// begin, end, interior.
    const std::vector<unsigned int> &
    nodes_of_cell(const unsigned int cell) const
    {
      return cell_nodes[cell];
    }

    /// Return the coordinate y of the begin and of the end of @p cell.
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

    /// Returns the shape functions of @p cell at y = cell_begin + @p eta
    /// (cell_end - cell_begin). Values of N below 1e-14 are set to zero.
    AxisPoint
    evaluate(const unsigned int cell, const double eta) const;

    /// Returns the elements that contain @p y within @p tolerance [length],
    /// each with the reference coordinate eta in [0, 1], which is exactly 0 or
    /// 1 at an end. There are two at inner element ends, none outside.
    std::vector<std::pair<unsigned int, double>>
    locate(const double y, const double tolerance) const;

    /// Returns the first element that contains @p node and the reference
    /// coordinate eta of the node in this element.
    std::pair<unsigned int, double>
    cell_of_node(const unsigned int node) const;

    /// Returns the tributary length int N_i dy of each node, which gives, times
    /// an edge length of the section, the tributary area of a contact node.
    std::vector<double>
    node_weights() const;

    /// Returns the integration points of all elements: degree + 1 Gauss points
    /// per element, exact for products N_i N_j.
    const std::vector<AxisPoint> &
    integration_points() const
    {
      return points;
    }

    /// Returns the integration weights [length], whose sum is length().
    const std::vector<double> &
    integration_weights() const
    {
      return weights;
    }

    /// Returns the axis matrix with the derivatives of order @p p of N_i (row)
    /// and @p q of N_j (column), 0 or 1: A(0, 1) = A_NdN. All matrices have the
    /// same sparsity pattern and are whole on every process.
    const Matrix &
    A(const unsigned int p, const unsigned int q) const
    {
      return matrices[2 * p + q];
    }

    /// Returns int N^_i N^_j, or A(0, 0) without assumed shear strains. This is
    /// the factor of Section::S_shear() in the stiffness.
    const Matrix &
    A_shear() const
    {
      return matrices[4];
    }

  private:
    /// Creates the elements of element_lengths(), distributed evenly.
    void
    make_mesh();
    /// Renumbers the nodes along y.
    void
    number_nodes();
    /// Computes the integration points and integrates the matrices.
    void
    make_matrices();

    /// Returns N^_i = sum_q L_q(eta) N_i(eta_q) at @p eta in [0, 1], with the
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

    /// Sparsity pattern, and the matrices A(p, q) at 2 p + q and A_shear at 4.
    dealii::SparsityPattern sparsity;
    std::array<Matrix, 5>   matrices;
  };
} // namespace lamella

#endif
