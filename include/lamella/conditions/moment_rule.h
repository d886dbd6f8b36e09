// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_moment_rule_h
#define lamella_conditions_moment_rule_h

#include <lamella/conditions/adaptive_moments.h>

#include <array>
#include <vector>

namespace lamella
{
  /// Box in the parameters of a cell under a line load (interval [0, 1]) or a
  /// surface load (unit square), created by repeated bisection.
  template <int dim>
  struct ParameterBox
  {
    dealii::Point<dim> low, ///< Corner with the smallest parameters.
      high;                 ///< Corner with the largest parameters.
    /// Number of times the cell was halved along each parameter.
    std::array<unsigned int, dim> bisections{};

    double
    volume() const; ///< Returns the product of the side lengths.

    dealii::Point<dim>
    center() const; ///< Returns the midpoint of the box.

    /// Returns the two boxes that halving along parameter @p d gives.
    std::array<ParameterBox, 2>
    halves(const unsigned int d) const;
  };

  /// Smallest and largest components of the load vectors passed to add().
  struct ForceRange
  {
    dealii::Tensor<1, 3> low, ///< Smallest value of each component.
      high;                   ///< Largest value of each component.
    bool empty = true;        ///< True until add() is called.

    void
    add(const dealii::Tensor<1, 3> &f); ///< Extends the range by @p f.

    /// Returns the largest excess of a component of @p f beyond its range
    /// widened by a quarter on both sides; 0 if there is none.
    double
    beyond(const dealii::Tensor<1, 3> &f) const;
  };

  /// A Gauss rule for the moments of a load over a box of a cell: the integrals
  /// of f phi_k, load f times Lagrange polynomial phi_k (Moments).
  template <int dim>
  class MomentRule
  {
  public:
    /// A cell with its load f and polynomial degrees (Moments::Cell).
    using Cell = typename Moments<dim>::Cell;

    /// Constructs the rule on @p box with p + 3 + @p more Gauss points along
    /// each parameter, where p is the polynomial degree of @p cell.
    MomentRule(const Cell              &cell,
               const ParameterBox<dim> &box,
               const unsigned int       more);

    /// Returns the number of Gauss points in the box.
    unsigned int
    n_points() const
    {
      return points;
    }

    /// Returns the integral of f phi_k for each Lagrange polynomial k, the
    /// first parameter running fastest. Adds the values of f to @p range.
    std::vector<dealii::Tensor<1, 3>>
    integrate(ForceRange &range) const;

  private:
    /// A Gauss point with its index along each parameter and its weight.
    struct Node
    {
      std::array<unsigned int, dim> at;
      dealii::Point<dim>            point;
      double                        weight = 1.;
    };

    Node
    node(const unsigned int q) const;
    /// Returns the Gauss weight of @p node times polynomial @p k at this node.
    double
    weighted(const Node &node, const unsigned int k) const;

    const Cell &cell;
    /// Along each parameter: Gauss points x, weights w, and the values phi of
    /// the Lagrange polynomials at these points.
    std::array<std::vector<double>, dim> x, w, phi;
    unsigned int                         points = 1, functions = 1;
  };
} // namespace lamella

#endif
