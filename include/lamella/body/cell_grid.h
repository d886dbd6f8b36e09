// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_cell_grid_h
#define lamella_body_cell_grid_h

#include <lamella/body/body.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace lamella
{
  /// A Gauss-Lobatto grid on the unit cube of an element, with the Lagrange
  /// polynomials N_k of its nodes, for interpolation of a function f by
  ///   f(u) = sum_k N_k(u) f_k.
  /// Nodes are ordered as in an OutputCell, xi running fastest.
  class CellGrid
  {
  public:
    /// Constructs a grid for polynomials of @p degrees >= 1 along xi, axis,
    /// eta.
    explicit CellGrid(const GridIntervals &degrees);

    /// Returns the positions of the grid's nodes in the unit cube [0, 1]^3.
    const std::vector<dealii::Point<3>> &
    nodes() const
    {
      return grid;
    }

    /// Lagrange polynomials of all nodes of the grid at one point.
    struct Functions
    {
      std::vector<double> N; ///< Values N_k of the polynomials, one per node.
      /// Gradients of the polynomials by the three unit coordinates.
      std::vector<dealii::Tensor<1, 3>> dN;
    };
    /// Returns the polynomials at the point @p unit of the unit cube.
    Functions
    evaluate(const dealii::Point<3> &unit) const;

    /// Returns the undeformed nodes in the element @p cell of @p body, scene
    /// axes.
    std::vector<dealii::Point<3>>
    positions(const Body &body, const unsigned int cell) const;

  private:
    GridIntervals                 degrees;
    std::vector<dealii::Point<3>> grid;
  };

  /// Returns the derivatives by unit coordinates of the function with the nodal
  /// values @p f, sum_k f_k (x) dN_k with the gradients dN_k of @p functions.
  /// For nodal positions this is the Jacobian.
  template <typename Values>
  dealii::Tensor<2, 3>
  unit_gradient(const Values &f, const CellGrid::Functions &functions)
  {
    dealii::Tensor<2, 3> sum;
    for (unsigned int k = 0; k < functions.dN.size(); ++k)
      for (unsigned int c = 0; c < 3; ++c)
        sum[c] += f[k][c] * functions.dN[k];
    return sum;
  }
} // namespace lamella

#endif
