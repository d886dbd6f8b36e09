// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `axis`: the mesh of a beam's axis, the elements B2, B3, B4 with
// their shape functions N_i(y) in u = F_tau N_i u_(tau i) (Eq. 7), and the
// matrices A_pq, integrals of N_i^(p) N_j^(q). It is independent of the section
// functions F_tau(x, z), which are in the room `section`.

#ifndef lamella_axis_axis_h
#define lamella_axis_axis_h

#include <lamella/base/linear_algebra.h>

#include <deal.II/distributed/shared_tria.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_q.h>

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
    /// the axis into intervals of equal elements.
    std::vector<double> breaks;
    /// Factor on the number of elements of automatic grading (grade_axes()),
    /// which computes `elements` and `breaks`; 0: no automatic grading.
    double refinement_factor = 0.;
    /// True if the nodes of B4 are equidistant, as in the CUF literature,
    /// instead of Gauss-Lobatto points. No effect on B2 and B3.
    bool equidistant_nodes = false;
    /// True if transverse shear strains are assumed strains of one degree less
    /// (MITC), which avoids shear locking.
    bool assumed_shear = false;
  };

  /// Returns the lengths of all elements of the axis mesh, by ascending y.
  std::vector<double>
  element_lengths(const AxisMesh &description);

  /// Shape functions N_i of an axis element at a point, for u = sum N_i u_i and
  /// du/dy = sum N_i' u_i with the nodal values u_i. Transverse shear strains
  /// have shape functions N^_i (Axis) instead of N_i.
  struct AxisPoint
  {
    /// Index of the element, from 0 along the axis.
    unsigned int cell = 0;
    /// Distance from the start of the axis [length].
    double y = 0.;
    /// Values N_i, in the order of Axis::nodes_of_cell().
    std::vector<double> N;
    std::vector<double> dN; ///< Derivatives dN_i / dy [1/length].
    /// Shape functions in transverse shear strains: N^_i if assumed, else N_i.
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
  /// Dvorkin and Bathe) replace N_i by polynomials N^_i of one degree less that
  /// interpolate N_i at the degree() Gauss points of an element. Only A_shear =
  /// int N^_i N^_j is additional, as int N^_i N_j' = int N_i N_j'.
  ///
  /// Every process stores the whole axis. Each owns contiguous ranges of
  /// elements for loops and of nodes for stiffness matrices. Immutable.
  class Axis
  {
  public:
    /// Creates the mesh and the axis matrices. Must be called by all processes.
    explicit Axis(const AxisMesh &description);

    /// Returns the degree of the shape functions N_i.
    unsigned int
    degree() const
    {
      return fe.degree;
    }

    /// Returns the length of the axis [length].
    double
    length() const
    {
      return description.length;
    }

    /// Returns true if transverse shear strains are assumed strains (MITC),
    /// false if they are those of the displacements.
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

    /// Returns the elements that this process integrates over: the index of the
    /// first and one past the last. The range may be empty.
    std::pair<unsigned int, unsigned int>
    own_cells() const
    {
      return owned_cells;
    }

    /// Returns the nodes whose rows of the stiffness matrix this process owns:
    /// the index of the first and one past the last.
    std::pair<unsigned int, unsigned int>
    own_nodes() const;

    /// Returns the coordinate y of each node, ascending from 0 to length().
    const std::vector<double> &
    nodes() const
    {
      return node_positions;
    }

    /// Returns the nodes of the element @p cell in the order of its shape
    /// functions AxisPoint::N: first node, last node, inner nodes.
    const std::vector<unsigned int> &
    nodes_of_cell(const unsigned int cell) const
    {
      return cell_nodes[cell];
    }

    /// Returns the coordinate y of the start of element @p cell [length].
    double
    cell_begin(const unsigned int cell) const
    {
      return cell_bounds[cell].first;
    }

    /// Returns the coordinate y of the end of element @p cell [length].
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
    /// with the reference coordinate eta in [0, 1] of @p y, exactly 0 or 1 at
    /// element ends. Returns two at a common end, none outside of the axis.
    std::vector<std::pair<unsigned int, double>>
    locate(const double y, const double tolerance) const;

    /// Returns the first element that contains @p node and the reference
    /// coordinate eta of the node in this element.
    std::pair<unsigned int, double>
    cell_of_node(const unsigned int node) const;

    /// Returns the integral int N_i dy of each node's shape function [length].
    std::vector<double>
    node_weights() const;

    /// Returns the integration points of all elements: degree() + 1 Gauss
    /// points per element, which integrate products N_i N_j exactly.
    const std::vector<AxisPoint> &
    integration_points() const
    {
      return points;
    }

    /// Returns the weights of integration_points() [length].
    const std::vector<double> &
    integration_weights() const
    {
      return weights;
    }

    /// Returns the axis matrix int N_i^(p) N_j^(q) dy, with derivatives of
    /// order @p p and @p q, 0 or 1. Every process stores the whole matrix. All
    /// matrices have the same sparsity pattern.
    const Matrix &
    A(const unsigned int p, const unsigned int q) const
    {
      return matrices[2 * p + q];
    }

    /// Returns the matrix int N^_i N^_j dy of the shape functions in transverse
    /// shear strains, or A(0, 0) if these strains are not assumed.
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

    /// Sparsity pattern of the matrices A(p, q) at 2 p + q and A_shear at 4.
    dealii::SparsityPattern sparsity;
    std::array<Matrix, 5>   matrices;
  };
} // namespace lamella

#endif
