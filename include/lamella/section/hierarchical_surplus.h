// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_hierarchical_surplus_h
#define lamella_section_hierarchical_surplus_h

#include <lamella/base/linear_functional.h>
#include <lamella/section/section.h>

#include <deal.II/lac/sparse_direct.h>

#include <array>
#include <vector>

namespace lamella
{
  /// Computes the hierarchical surplus of a displacement v over a section with
  /// theory LE-p: the difference between v and its interpolant L_q v of lower
  /// degree q < p at the Gauss-Lobatto points of each cell. The coefficients c'
  /// of the surplus follow from its nodal values,
  ///   E c' = nodal values of (1 - L_q) v,
  /// where the matrix E maps coefficients of section functions to nodal values.
  /// It is factorized once. Keeps a reference to the section.
  class HierarchicalSurplus
  {
  public:
    /// Returns true if @p section has a layer-wise theory, with nodal values.
    static bool
    is_possible(const Section &section);

    /// Factorizes the matrix from coefficients to nodal values of @p section,
    /// which has a theory LE-p, p > 1. Requires is_possible().
    explicit HierarchicalSurplus(const Section &section);

    /// Returns the degree p of the section's theory LE-p.
    unsigned int
    degree() const
    {
      return section.element().degree();
    }

    /// Replaces the coefficients @p c of a displacement by those of its surplus
    /// over the interpolant of degree @p q, where 0 < @p q < degree().
    void
    remove_lower_degree(const unsigned int q, Vector &c) const;

  private:
    /// Returns the displacement components x, y, z at the point @p unit of @p
    /// cell as linear functionals of the coefficients of section functions.
    std::array<LinearFunctional, 3>
    displacement(const unsigned int cell, const dealii::Point<2> &unit) const;
    /// Returns displacement() for the interpolant of degree @p q.
    std::array<LinearFunctional, 3>
    interpolated(const unsigned int      cell,
                 const dealii::Point<2> &unit,
                 const unsigned int      q) const;
    /// Assembles and factorizes the matrix from coefficients to nodal values.
    void
    factorize(const std::vector<EdgePoint> &nodes);

    const Section &section;
    /// Factorization of the matrix from coefficients to nodal values.
    dealii::SparseDirectUMFPACK from_nodes;
    /// For each degree q = 1 ... degree() - 1, three functionals per node:
    /// displacement minus interpolant of degree q.
    std::vector<std::vector<LinearFunctional>> beyond;
  };
} // namespace lamella

#endif
