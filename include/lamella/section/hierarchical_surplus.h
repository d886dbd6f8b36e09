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
  /// The part of a displacement of a section of LE-p beyond LE-q,
  ///   (1 - L_q) v,
  /// with L_q the interpolation by cells at the Gauss-Lobatto points of degree
  /// q. It drops the integrated Legendre polynomials of degrees above q in a
  /// direction, which vanish there; neighbors agree on their common side. It
  /// works for any basis, by nodal values,
  ///   E c' = (1 - L_q) c at the nodes,
  /// with E factorized once. Refers to the section.
  class HierarchicalSurplus
  {
  public:
    /// Returns true if nodes determine the fields of @p section (layer-wise).
    static bool
    is_possible(const Section &section);

    /// Constructs the surplus of an LE-p, p above 1, that is_possible().
    explicit HierarchicalSurplus(const Section &section);

    unsigned int
    degree() const
    {
      return section.element().degree();
    }

    /// Removes the part in LE-@p q, 0 < q < degree(), from the coefficients
    /// @p c.
    void
    remove_lower_degree(const unsigned int q, Vector &c) const;

  private:
    /// Returns the displacement at a point of @p cell, one row per component,
    /// in terms of coefficients of the fields.
    std::array<LinearFunctional, 3>
    displacement(const unsigned int cell, const dealii::Point<2> &unit) const;
    /// Returns the displacement interpolated in degree @p q.
    std::array<LinearFunctional, 3>
    interpolated(const unsigned int      cell,
                 const dealii::Point<2> &unit,
                 const unsigned int      q) const;
    /// Assembles and factorizes E.
    void
    factorize(const std::vector<EdgePoint> &nodes);

    const Section &section;
    /// Factorization of E, from displacements at the nodes to coefficients.
    dealii::SparseDirectUMFPACK from_nodes;
    /// Rows of (1 - L_q) c at the nodes, three each, of q = 1 ... degree() - 1.
    std::vector<std::vector<LinearFunctional>> beyond;
  };
} // namespace lamella

#endif
