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
  /// Computes the hierarchical surplus of a displacement v of a section with
  /// theory LE-p: the part of v that the lower degree q < p cannot represent,
  ///   (1 - L_q) v,
  /// where L_q v interpolates v in each cell at the Gauss-Lobatto points of
  /// degree q. Coefficients c' of the surplus follow from the coefficients c of
  /// v by
  ///   E c' = (1 - L_q) c at the nodes,
  /// where the matrix E maps coefficients to nodal values. It is factorized
  /// once. Keeps a reference to the section.
  class HierarchicalSurplus
  {
  public:
    /// Returns true if nodal values determine the displacements of @p section,
    /// as in layer-wise theories.
    static bool
    is_possible(const Section &section);

    /// Factorizes E for @p section of LE-p, p > 1. Requires is_possible().
    explicit HierarchicalSurplus(const Section &section);

    unsigned int
    degree() const
    {
      return section.element().degree();
    }

    /// Replaces the coefficients @p c by those of the surplus over LE-@p q,
    /// where 0 < @p q < degree().
    void
    remove_lower_degree(const unsigned int q, Vector &c) const;

  private:
    /// Returns the three displacement components at a point of @p cell as
    /// functionals of the coefficients.
    std::array<LinearFunctional, 3>
    displacement(const unsigned int cell, const dealii::Point<2> &unit) const;
    /// Returns the interpolant of degree @p q in the cell of displacement().
    std::array<LinearFunctional, 3>
    interpolated(const unsigned int      cell,
                 const dealii::Point<2> &unit,
                 const unsigned int      q) const;
    /// Assembles and factorizes the matrix E of nodal values.
    void
    factorize(const std::vector<EdgePoint> &nodes);

    const Section &section;
    /// Factorization of E, the matrix from coefficients to nodal values.
    dealii::SparseDirectUMFPACK from_nodes;
    /// Functionals (1 - L_q) v, three per node, for q = 1 ... degree() - 1.
    std::vector<std::vector<LinearFunctional>> beyond;
  };
} // namespace lamella

#endif
