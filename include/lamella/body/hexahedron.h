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
  /// The stiffness C at a point of a hexahedron, in the axes of its nodes.
  using StiffnessField = std::function<ElasticTensor(const dealii::Point<3> &)>;

  /// Shape functions of a hexahedron at one of its points.
  struct HexahedronPoint
  {
    dealii::Point<3> unit, position;
    /// Derivative d(x, y, z) / d(unit coordinates).
    dealii::Tensor<2, 3> jacobian;
    /// Weight of a quadrature point times det(jacobian).
    double                            JxW = 0.;
    std::vector<double>               N;
    std::vector<dealii::Tensor<1, 3>> gradients;
  };

  /// Data of the incompatible modes of a hexahedron of degree 1.
  struct IncompatibleModes
  {
    /// Matrix A of a = A u, 9 x 24; empty without modes.
    dealii::FullMatrix<double> A;
    /// Product det J_0 J_0^-T.
    dealii::Tensor<2, 3> middle;
  };

  /**
   * The isoparametric hexahedron of degree 1 or 2 with full integration. DoF 3
   * i + c is the component c at its node i.
   *
   * Degree 1 has the incompatible modes of Wilson as modified by Taylor,
   * Beresford and Wilson (1976), which pass the patch test and prevent locking
   * in bending:
   *   u = sum N_i u_i + sum_k (1 - xi_k^2) a_k.
   * Gradients of the modes use the Jacobian J_0 of the middle, (det J_0 / det
   * J) J_0^-T grad (1 - xi_k^2), so that their mean vanishes. The nine a are
   * condensed out on each element, a = A u with A = -K_aa^-1 K_au, and complete
   * its strains.
   *
   * Geometry and shape functions are deal.II's on one cell, whose mapping is
   * set to the nodes in question. Each call changes the cell: not thread-safe.
   */
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

    /// Returns the place of node @p i in the unit cube.
    const dealii::Point<3> &
    unit_node(const unsigned int i) const
    {
      return fe.get_unit_support_points()[i];
    }

    /// Returns the cell and sets mapping() from the unit cube to x - x_0 with
    /// the first of @p nodes x_0, without loss of digits far from the origin.
    dealii::Triangulation<3>::active_cell_iterator
    cell(const Nodes &nodes) const;

    const dealii::Mapping<3> &
    mapping() const
    {
      return geometry;
    }

    HexahedronPoint
    evaluate(const Nodes &nodes, const dealii::Point<3> &unit) const;

    /// Returns the points of full integration.
    std::vector<HexahedronPoint>
    quadrature_points(const Nodes &nodes) const;

    IncompatibleModes
    incompatible_modes(const Nodes &nodes, const StiffnessField &C) const;

    /// Returns the strains of unit DoFs at @p point: epsilon = sum strains u_d.
    std::vector<Voigt>
    strains(const HexahedronPoint &point, const IncompatibleModes &modes) const;

    /// Returns int B^T C B dV.
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
