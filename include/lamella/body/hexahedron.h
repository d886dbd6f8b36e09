// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_hexahedron_h
#define lamella_body_hexahedron_h

#include <lamella/material/elasticity.h>

#include <deal.II/base/point.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q_cache.h>

#include <deal.II/grid/tria.h>

#include <deal.II/lac/full_matrix.h>

#include <deal.II/matrix_free/fe_point_evaluation.h>

#include <functional>
#include <vector>

namespace lamella
{
  /// Elasticity matrix C as a function of the position in a hexahedron.
  using StiffnessField = std::function<ElasticTensor(const dealii::Point<3> &)>;

  /// Shape functions of a hexahedron at one point.
  struct HexahedronPoint
  {
    dealii::Point<3> unit,         ///< Coordinates in the unit cube [0, 1]^3.
      position;                    ///< Position x, y, z in body axes.
    dealii::Tensor<2, 3> jacobian; ///< d(x, y, z) / d(unit coordinates).
    /// Weight of a quadrature point times det(jacobian).
    double              JxW = 0.;
    std::vector<double> N; ///< Values of the shape functions.
    /// Gradients of the shape functions by x, y, z.
    std::vector<dealii::Tensor<1, 3>> gradients;
  };

  /// Incompatible modes of a trilinear hexahedron, with nine amplitudes a.
  struct IncompatibleModes
  {
    /// Matrix A (9 x 24) of a = A u, u nodal displacements; empty for degree 2.
    dealii::FullMatrix<double> A;
    /// Matrix det(J_0) J_0^-T with the Jacobian J_0 at the element center.
    dealii::Tensor<2, 3> middle;
  };

  /// The isoparametric hexahedron of degree 1 or 2 with full integration. DoF 3
  /// i + c is the displacement component c at node i.
  ///
  /// For degree 1, incompatible modes of Taylor, Beresford and Wilson (1976),
  /// which pass the patch test, prevent locking in bending:
  ///   u = sum N_i u_i + sum_k (1 - xi_k^2) a_k.
  /// Gradients of the modes are (det J_0 / det J) J_0^-T grad (1 - xi_k^2) with
  /// the Jacobian J_0 at the center. The nine amplitudes a are condensed on
  /// each element: a = A u with A = -K_aa^-1 K_au. Not thread-safe: all
  /// functions use the same cell of deal.II.
  class Hexahedron
  {
  public:
    /// Positions of the nodes of a hexahedron, in the order of FE_Q.
    using Nodes = std::vector<dealii::Point<3>>;

    /// Constructs the element of @p degree 1 (8 nodes) or 2 (27 nodes).
    explicit Hexahedron(const unsigned int degree);

    /// Returns the polynomial degree, 1 or 2.
    unsigned int
    degree() const
    {
      return fe.degree;
    }

    /// Returns the number of nodes, 8 or 27.
    unsigned int
    n_nodes() const
    {
      return fe.n_dofs_per_cell();
    }

    /// Returns the unit coordinates of node @p i.
    const dealii::Point<3> &
    unit_node(const unsigned int i) const
    {
      return fe.get_unit_support_points()[i];
    }

    /// Sets mapping() to @p nodes, with the first node as origin to avoid loss
    /// of digits. Returns the mapped cell of deal.II.
    dealii::Triangulation<3>::active_cell_iterator
    cell(const Nodes &nodes) const;

    /// Returns the mapping that cell() sets.
    const dealii::Mapping<3> &
    mapping() const
    {
      return geometry;
    }

    /// Returns the shape functions at the unit coordinates @p unit.
    HexahedronPoint
    evaluate(const Nodes &nodes, const dealii::Point<3> &unit) const;

    /// Returns the shape functions at the Gauss points of full integration.
    std::vector<HexahedronPoint>
    quadrature_points(const Nodes &nodes) const;

    /// Returns the incompatible modes, condensed with the elasticity @p C.
    IncompatibleModes
    incompatible_modes(const Nodes &nodes, const StiffnessField &C) const;

    /// Returns the columns of the strain-displacement matrix B at @p point.
    std::vector<Voigt>
    strains(const HexahedronPoint &point, const IncompatibleModes &modes) const;

    /// Returns the element stiffness int B^T C B dV.
    dealii::FullMatrix<double>
    stiffness(const Nodes             &nodes,
              const StiffnessField    &C,
              const IncompatibleModes &modes) const;

  private:
    dealii::FE_Q<3>                         fe;
    dealii::Triangulation<3>                any_cell;
    mutable dealii::MappingQCache<3>        geometry;
    mutable dealii::FEPointEvaluation<1, 3> at_point;
  };
} // namespace lamella

#endif
