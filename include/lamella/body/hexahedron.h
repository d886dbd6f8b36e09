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
  /// Elasticity matrix C as a function of the point in a hexahedron.
  using StiffnessField = std::function<ElasticTensor(const dealii::Point<3> &)>;

  /// Values N_i and gradients of shape functions at a point of a hexahedron.
  struct HexahedronPoint
  {
    dealii::Point<3> unit, position;
    /// Jacobian d(x, y, z) / d(unit coordinates).
    dealii::Tensor<2, 3> jacobian;
    /// Weight of a quadrature point times det(jacobian).
    double                            JxW = 0.;
    std::vector<double>               N;
    std::vector<dealii::Tensor<1, 3>> gradients;
  };

  /// Data of the incompatible modes (amplitudes a) of a trilinear hexahedron.
  struct IncompatibleModes
  {
    /// Matrix A (9 x 24) of a = A u, u the nodal displacements; may be empty.
    dealii::FullMatrix<double> A;
    /// det J_0 J_0^-T, with the Jacobian J_0 at the element center.
    dealii::Tensor<2, 3> middle;
  };

  /// The isoparametric hexahedron of degree 1 or 2 with full integration. DoF 3
  /// i + c is the component c at its node i.
  ///
  /// For degree 1, incompatible modes of Taylor, Beresford and Wilson (1976),
  /// which pass the patch test, prevent locking in bending:
  ///   u = sum N_i u_i + sum_k (1 - xi_k^2) a_k.
  /// Gradients of the modes are (det J_0 / det J) J_0^-T grad (1 - xi_k^2) with
  /// the Jacobian J_0 at the center. The nine amplitudes a are condensed on
  /// each element: a = A u with A = -K_aa^-1 K_au.
  ///
  /// Geometry and shape functions are computed by deal.II on one cell, which
  /// each call maps to the given nodes: not thread-safe.
  class Hexahedron
  {
  public:
    using Nodes = std::vector<dealii::Point<3>>;

    explicit Hexahedron(const unsigned int degree);

    unsigned int
    degree() const
    {
      return fe.degree;
    }

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

    /// Returns the cell after setting mapping() to positions relative to the
    /// first of @p nodes, which avoids loss of digits far from the origin.
    dealii::Triangulation<3>::active_cell_iterator
    cell(const Nodes &nodes) const;

    const dealii::Mapping<3> &
    mapping() const
    {
      return geometry;
    }

    HexahedronPoint
    evaluate(const Nodes &nodes, const dealii::Point<3> &unit) const;

    /// Returns the Gauss points of full integration.
    std::vector<HexahedronPoint>
    quadrature_points(const Nodes &nodes) const;

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
