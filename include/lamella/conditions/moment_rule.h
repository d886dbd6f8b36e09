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
    /// How often along each parameter.
    std::array<unsigned int, dim> bisections{};

    double
    volume() const;

    dealii::Point<dim>
    centre() const;

    /// The two of its bisection along parameter @p d.
    std::array<ParameterBox, 2>
    halves(const unsigned int d) const;
  };

  /// The smallest and the largest value of each component, of all that were
  /// added.
  struct ForceRange
  {
    dealii::Tensor<1, 3> low, high;
    bool                 empty = true;

    void
    add(const dealii::Tensor<1, 3> &f);

    /// How far @p f is from what is known: a quarter of the range beyond it and
    /// further; else 0.
    double
    beyond(const dealii::Tensor<1, 3> &f) const;
  };

  /**
   * Gauss' rule over a box of a cell, for integrals of f phi_k (Moments), with
   * degree + 3 and some more points along each parameter.
   */
  template <int dim>
  class MomentRule
  {
  public:
    using Cell = typename Moments<dim>::Cell;

    /// With @p more points along each parameter. Refers to @p cell.
    MomentRule(const Cell              &cell,
               const ParameterBox<dim> &box,
               const unsigned int       more);

    unsigned int
    n_points() const
    {
      return points;
    }

    /// The integrals, in the order of Moments::of_cells; the values of f that
    /// they are made of into @p range.
    std::vector<dealii::Tensor<1, 3>>
    integrate(ForceRange &range) const;

  private:
    /// One of the points: its numbers along each parameter.
    struct Node
    {
      std::array<unsigned int, dim> at;
      dealii::Point<dim>            point;
      double                        weight = 1.;
    };

    Node
    node(const unsigned int q) const;
    /// w phi_k there.
    double
    weighted(const Node &node, const unsigned int k) const;

    const Cell &cell;
    /// Points, weights and functions of each parameter, once.
    std::array<std::vector<double>, dim> x, w, phi;
    unsigned int                         points = 1, functions = 1;
  };
} // namespace lamella

#endif
