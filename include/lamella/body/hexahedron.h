// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_hexahedron_h
#define lamella_body_hexahedron_h

#include <lamella/material/elasticity.h>

#include <deal.II/base/point.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_q.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace lamella
{
  /// A hexahedron's shape functions at one of its points.
  struct HexahedronPoint
  {
    dealii::Point<3> unit, position;
    /// d(x, y, z) / d(unit coordinates).
    dealii::Tensor<2, 3>              jacobian;
    std::vector<double>               N;
    std::vector<dealii::Tensor<1, 3>> gradients;
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

    HexahedronPoint
    evaluate(const Nodes &nodes, const dealii::Point<3> &unit) const;

    const dealii::Quadrature<3> &
    quadrature() const
    {
      return gauss;
    }

    /// A of a = A u, 9 x 24; empty for degree 2, which has no modes.
    dealii::FullMatrix<double>
    incompatible_modes(const Nodes &nodes, const ElasticTensor &C) const;

    /// The strains that each DoF alone makes at @p point, the modes @p A
    /// included: epsilon = sum strains[d] u_d.
    std::vector<Voigt>
    strains(const Nodes                      &nodes,
            const HexahedronPoint            &point,
            const dealii::FullMatrix<double> &A) const;

    /// int B^T C B dV.
    dealii::FullMatrix<double>
    stiffness(const Nodes                      &nodes,
              const ElasticTensor              &C,
              const dealii::FullMatrix<double> &A) const;

  private:
    /// The strains of the nine modes at @p point.
    std::vector<Voigt>
    mode_strains(const Nodes &nodes, const HexahedronPoint &point) const;

    dealii::FE_Q<3>   fe;
    dealii::QGauss<3> gauss;
  };
} // namespace lamella

#endif
