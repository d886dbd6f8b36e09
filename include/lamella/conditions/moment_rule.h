// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_moment_rule_h
#define lamella_conditions_moment_rule_h

#include <lamella/conditions/adaptive_moments.h>

#include <array>
#include <vector>

namespace lamella
{
  /// A part of a cell's unit square (or interval), made by bisection.
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

  /// Smallest and largest value of each component of the added values.
  struct ForceRange
  {
    dealii::Tensor<1, 3> low, high;
    bool                 empty = true;

    void
    add(const dealii::Tensor<1, 3> &f);

    /// Returns how far @p f is beyond the range, a quarter wider each way.
    double
    beyond(const dealii::Tensor<1, 3> &f) const;
  };

  /// A Gauss rule over a box of a cell for integrals of f phi_k (Moments).
  template <int dim>
  class MomentRule
  {
  public:
    using Cell = typename Moments<dim>::Cell;

    /// Sets up degree + 3 and @p more points along each parameter of @p cell.
    MomentRule(const Cell              &cell,
               const ParameterBox<dim> &box,
               const unsigned int       more);

    unsigned int
    n_points() const
    {
      return points;
    }

    /// Returns the integrals as Moments::of_cells. Adds the values to @p range.
    std::vector<dealii::Tensor<1, 3>>
    integrate(ForceRange &range) const;

  private:
    /// A point of the rule, with its index along each parameter.
    struct Node
    {
      std::array<unsigned int, dim> at;
      dealii::Point<dim>            point;
      double                        weight = 1.;
    };

    Node
    node(const unsigned int q) const;
    /// Returns w phi_k at @p node.
    double
    weighted(const Node &node, const unsigned int k) const;

    const Cell &cell;
    /// Points, weights and functions of each parameter.
    std::array<std::vector<double>, dim> x, w, phi;
    unsigned int                         points = 1, functions = 1;
  };
} // namespace lamella

#endif
