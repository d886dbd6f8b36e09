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
  /// C at a point of a hexahedron, both in the axes that its nodes are given
  /// in: plies that follow a curved wall have another one at each point.
  using StiffnessAt = std::function<ElasticTensor(const dealii::Point<3> &)>;

  /// A hexahedron's shape functions at one of its points.
  struct HexahedronPoint
  {
    dealii::Point<3> unit, position;
    /// d(x, y, z) / d(unit coordinates).
    dealii::Tensor<2, 3> jacobian;
    /// Of a quadrature point: its weight times det(jacobian).
    double                            JxW = 0.;
    std::vector<double>               N;
    std::vector<dealii::Tensor<1, 3>> gradients;
  };

  /// What the modes of a hexahedron of degree 1 are made from.
  struct IncompatibleModes
  {
    /// A of a = A u, 9 x 24; empty where there are no modes.
    dealii::FullMatrix<double> A;
    /// det J_0 J_0^-T.
    dealii::Tensor<2, 3> middle;
  };

  /**
   * The isoparametric hexahedron of degree 1 or 2 with full integration.
   *
   * That of degree 1 has the incompatible modes of Wilson in the form of
   * Taylor, Beresford and Wilson (1976), which passes the patch test:
   *   u = sum N_i u_i + sum_k (1 - xi_k^2) a_k,
   * the gradients of the modes taken with the Jacobian J_0 of the middle,
   * (det J_0 / det J) J_0^-T grad (1 - xi_k^2), so that their mean vanishes.
   * Bending then does not lock. The nine a are condensed out on each element,
   * a = A u with A = -K_aa^-1 K_au, and complete its strains.
   *
   * DoF 3 i + c of a hexahedron is the component c at its node i.
   *
   * Geometry and shape functions are deal.II's, which wants a cell of a
   * triangulation. A process has those of its own cells only, and matrices,
   * points and surfaces are asked for on all of them: so one cell stands for
   * any, its mapping made from the nodes in question, with the same numbers on
   * every process. Each call changes it: no two threads may share a Hexahedron.
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

    /// The place of node @p i in the unit cube.
    const dealii::Point<3> &
    unit_node(const unsigned int i) const
    {
      return fe.get_unit_support_points()[i];
    }

    /// The cell, on which mapping() is now that of @p nodes, from the unit cube
    /// to x - x_0, x_0 the first node: no digits are lost far from the origin.
    dealii::Triangulation<3>::active_cell_iterator
    cell(const Nodes &nodes) const;

    const dealii::Mapping<3> &
    mapping() const
    {
      return geometry;
    }

    HexahedronPoint
    evaluate(const Nodes &nodes, const dealii::Point<3> &unit) const;

    /// Those of full integration.
    std::vector<HexahedronPoint>
    quadrature_points(const Nodes &nodes) const;

    IncompatibleModes
    incompatible_modes(const Nodes &nodes, const StiffnessAt &C) const;

    /// The strains that each DoF alone makes at @p point, @p modes included:
    /// epsilon = sum strains[d] u_d.
    std::vector<Voigt>
    strains(const HexahedronPoint &point, const IncompatibleModes &modes) const;

    /// int B^T C B dV.
    dealii::FullMatrix<double>
    stiffness(const Nodes             &nodes,
              const StiffnessAt       &C,
              const IncompatibleModes &modes) const;

  private:
    dealii::FE_Q<3>                         fe;
    dealii::Triangulation<3>                any_cell;
    mutable dealii::MappingQCache<3>        geometry;
    mutable dealii::FEPointEvaluation<1, 3> at_point;
  };
} // namespace lamella

#endif
