// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_moment_rule_h
#define lamella_conditions_moment_rule_h

#include <lamella/conditions/adaptive_moments.h>

#include <array>
#include <vector>

namespace lamella
{
  /// A box in the unit square (or interval) of a cell of a load, created by
  /// bisection, with the corners `low` and `high`.
  template <int dim>
  struct ParameterBox
  {
    dealii::Point<dim> low, high;
    /// Number of bisections along each parameter.
    std::array<unsigned int, dim> bisections{};

    double
    volume() const;

    dealii::Point<dim>
    center() const;

    /// Returns the two halves along parameter @p d.
    std::array<ParameterBox, 2>
    halves(const unsigned int d) const;
  };

  /// Smallest and largest components of the loads f passed to add().
  struct ForceRange
  {
    dealii::Tensor<1, 3> low, high;
    bool                 empty = true;

    void
    add(const dealii::Tensor<1, 3> &f);

    /// Returns the distance of @p f from the range, after the range is widened
    /// by a quarter of its width on both sides.
    double
    beyond(const dealii::Tensor<1, 3> &f) const;
  };

  /// A Gauss rule for the integrals of f phi_k (load times polynomial k, see
  /// Moments) over a box of a cell.
  template <int dim>
  class MomentRule
  {
  public:
    using Cell = typename Moments<dim>::Cell;

    /// Constructs a rule of degree + 3 + @p more points along each parameter.
    MomentRule(const Cell              &cell,
               const ParameterBox<dim> &box,
               const unsigned int       more);

    unsigned int
    n_points() const
    {
      return points;
    }

    /// Returns the integral of f phi_k for each k, ordered as in
    /// Moments::of_cells. Adds the values of f to @p range.
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
    /// Returns the Gauss weight of @p node times the polynomial phi_k there.
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
